#include "database/format/dump.h"
#include "database/format/read.h"
#include "database/format/summary.h"
#include "database/format/write.h"
#include "tests/database/format/sample_database.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace linkdig::database {

namespace {

using nlohmann::json;
using testing::HasSubstr;

TEST(Summary, CountsListByList) {
    const DatabaseSummary summary = summarise(sample_database());
    ASSERT_EQ(summary.lists.size(), 4U);
    const ListSummary& hull = summary.lists[0];
    EXPECT_EQ(hull.faces, 2U);
    EXPECT_EQ(hull.corners, 8U);
    EXPECT_EQ(hull.smooth_faces, 2U);
    EXPECT_EQ(hull.faces_at_most, 2U);
    EXPECT_EQ(hull.planes, 1U);
    EXPECT_EQ(hull.tree_depth, 1U);
    EXPECT_EQ(hull.leaves, 2U);
    ASSERT_TRUE(hull.extent);
    EXPECT_EQ(hull.extent->least, Vec3f(0, 0, 0));
    EXPECT_EQ(hull.extent->greatest, Vec3f(1, 1, 1.5F)) << "of a light point";
    EXPECT_EQ(hull.lights, 2U);
    EXPECT_EQ(summary.objects[0].lights, 2U);
    EXPECT_FALSE(hull.reaches_infinity);
}

TEST(Summary, OneAlternativeOfASlotIsPresentAtATime) {
    EXPECT_EQ(summarise(sample_database()).lists[1].faces, 2U);
    EXPECT_EQ(summarise(sample_database()).lists[1].faces_at_most, 1U);
}

TEST(Summary, VerticesAtInfinityHaveNoExtent) {
    const DatabaseSummary summary = summarise(sample_database());
    EXPECT_TRUE(summary.lists[3].reaches_infinity);
    EXPECT_EQ(summary.lists[3].extent->greatest, Vec3f(1, 1, 0));
    EXPECT_FALSE(summary.lists[2].extent);
}

TEST(DumpJson, IsATreeOfListsAndObjects) {
    const json dump = json::parse(dump_json(sample_database(), 0xabc));
    EXPECT_EQ(dump["name"], "sample");
    EXPECT_EQ(dump["id"], "0000000000000abc");
    EXPECT_EQ(dump["totals"]["faces"], 5);
    EXPECT_EQ(dump["totals"]["lights"], 2);
    EXPECT_EQ(dump["lists"][0]["lights"], 2);
    EXPECT_EQ(dump["slots"], json::parse(R"([{"name": "wake", "alternatives": 2}])"));
    EXPECT_EQ(dump["clusters"][0]["moving_object"], "lph");
    EXPECT_EQ(dump["clusters"][1]["moving_object"], nullptr);
    EXPECT_EQ(dump["clusters"][1]["priority"], 7);
    const json& wake = dump["lists"][1];
    EXPECT_EQ(wake["name"], "wake");
    EXPECT_EQ(wake["cluster"], "ship");
    EXPECT_EQ(wake["attachment"], "waterline");
    EXPECT_EQ(wake["sun"], "ocean");
    EXPECT_EQ(wake["faces_at_most"], 1);
    EXPECT_EQ(
        wake["objects"],
        json::parse(
            R"([{"name": "wake.1", "faces": 1, "corners": 4, "edges": 4, "slot": "wake", "alternative": 0},
        {"name": "wake.2", "faces": 1, "corners": 4, "edges": 4, "slot": "wake", "alternative": 1}])"));
    EXPECT_EQ(dump["lists"][0]["extent"]["greatest_m"], json({1.0, 1.0, 1.5}));
    EXPECT_EQ(dump["lists"][2]["tile"]["cell_m"], 12.5);
    EXPECT_EQ(dump["lists"][2]["extent"], nullptr);
}

TEST(Summary, CountsLevelByLevel) {
    const DatabaseSummary summary = summarise(sample_database());
    ASSERT_EQ(summary.levels.size(), 3U);
    EXPECT_EQ(summary.levels[0].objects, 1U);
    EXPECT_EQ(summary.levels[0].faces, 1U);
    EXPECT_EQ(summary.levels[0].edges, 4U);
    EXPECT_EQ(summary.levels[1].edges, 0U);
}

TEST(DumpJson, TellsLevelsOfDetail) {
    const json dump = json::parse(dump_json(sample_database(), 1));
    EXPECT_EQ(dump["totals"]["details"], 2);
    EXPECT_EQ(dump["details"][0], json::parse(R"({"name": "runway", "cluster": "ground",
        "reference_m": [0.5, 0.5, 0.0], "hysteresis_m": 0.0, "blend_m": 50.0, "added": false,
        "levels": [{"to_m": 500.0, "objects": 1, "faces": 1, "edges": 4}]})"));
    EXPECT_EQ(dump["details"][1]["levels"].size(), 2U);
    EXPECT_EQ(dump["lists"][3]["objects"][0]["detail"], "runway");
    EXPECT_EQ(dump["lists"][3]["objects"][0]["level"], 0);
}

TEST(DumpText, NamesListsAndSlots) {
    const std::string text = dump_text(sample_database(), 0xabc);
    EXPECT_THAT(text, HasSubstr("sample (id 0000000000000abc): 5 faces"));
    EXPECT_THAT(text, HasSubstr("slot wake: 2 alternatives"));
    EXPECT_THAT(text, HasSubstr("detail runway of ground: to 500 m 1 faces 4 edges; blend 50 m\n"));
    EXPECT_THAT(text, HasSubstr("detail ship of ship: to 100 m 0 faces 0 edges, to 250 m 0 faces 0 edges; "
                                "hysteresis 5 m; levels add up\n"));
    EXPECT_THAT(text, HasSubstr("1 x 1 x 1.5 m"));
    EXPECT_THAT(text, HasSubstr("tile, to the horizon"));
}

TEST(Dump, TakesNamesThatAreNoUtf8) {
    VisualDatabase database = sample_database();
    database.name = "\xff\xfe";
    database.lists[0].name = "hull\xc3";
    database.clusters[0].name = "\xe2\x82";
    const ReadResult read = decode_database(encode_database(database));
    ASSERT_TRUE(read.database) << read.error;
    EXPECT_FALSE(dump_text(*read.database, 1).empty());
    const json dump = json::parse(dump_json(*read.database, 1)); // which throws if it is no UTF-8
    EXPECT_EQ(dump["lists"][0]["name"], "hull\xef\xbf\xbd");
}

} // namespace

} // namespace linkdig::database
