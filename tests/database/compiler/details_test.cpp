/// Levels of detail: what the compiler makes of them, and every mistake that an author can make.

#include "tests/database/compiler/authored.h"
#include "tests/database/compiler/solids.h"

#include "database/format/summary.h"
#include "database/format/validate.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

namespace linkdig::database {
namespace {

using testing::HasSubstr;

/// Line 15 on.
std::string detail(const std::string& more) {
    return "[[detail]]\nname = \"d\"\ncluster = \"cluster\"\nreference_m = [1, 2, 3]\n" + more;
}

std::string level_box(const std::string& name, int level, double size, const std::string& more = "") {
    return fmt::format(
        "[[object]]\nname = \"{}\"\nlist = \"list\"\ncolour = \"grey\"\ndetail = \"d\"\nlevel = {}\n{}"
        "[[object.box]]\nfrom_m = [{}, {}, {}]\nto_m = [{}, {}, {}]\n",
        name, level, more, -size, -size, -size, size, size, size);
}

std::string said(const std::string& text) {
    const CompileResult result = compile_text(scene(text));
    EXPECT_FALSE(result.database) << text;
    return messages(result);
}

TEST(Details, BecomeATableThatObjectsAndRunsPointInto) {
    const CompileResult result =
        compile_text(scene(detail("to_ft = [1000, 2000]\nhysteresis_m = 20\n") + level_box("fine", 0, 1) +
                           level_box("coarse", 1, 1) + // in the very same place
                           "[[object]]\nname = \"always\"\nlist = \"list\"\ncolour = \"grey\"\n"
                           "[[object.rectangle]]\ncentre_m = [0, 0, -5]\nsize_m = [9, 9]\n"));
    ASSERT_TRUE(result.database) << messages(result);
    const VisualDatabase& d = *result.database;
    EXPECT_EQ(validate(d), "");
    ASSERT_EQ(d.details.size(), 1U);
    EXPECT_EQ(d.details[0].name, "d");
    EXPECT_EQ(d.details[0].reference_m, Vec3d(1, 2, 3));
    EXPECT_EQ(d.details[0].hysteresis_m, 20.0F);
    ASSERT_EQ(d.detail_levels.size(), 2U);
    EXPECT_FLOAT_EQ(d.detail_levels[0].to_m, 304.8F);
    EXPECT_FLOAT_EQ(d.detail_levels[1].to_m, 609.6F);
    EXPECT_EQ(d.objects[0].level, 0);
    EXPECT_EQ(d.objects[1].level, 1);
    EXPECT_EQ(d.objects[2].level, none);
    EXPECT_EQ(result.statistics.total().faces_at_once, 7U);
    const DatabaseSummary summary = summarise(d);
    EXPECT_EQ(summary.lists[0].faces_at_most, 7U);
    EXPECT_EQ(summary.levels[0].edges, 12U);
    EXPECT_EQ(summary.levels[1].edges, 12U);
}

TEST(Details, LevelsThatReplaceEachOtherAreNeverCompared) {
    std::string text = detail("to_m = [100, 200, 300, 400]\n");
    for (int k = 0; k < 4; ++k) // they pass through each other, and share planes
        text += fmt::format(
            "[[object]]\nname = \"o{}\"\nlist = \"list\"\ncolour = \"grey\"\ndetail = \"d\"\nlevel = {}\n"
            "[[object.box]]\nfrom_m = [{}, 0, 0]\nto_m = [{}, 3, 3]\n",
            k, k, -k, k + 1);
    const CompileResult result = compile_text(scene(text));
    ASSERT_TRUE(result.database) << messages(result);
    EXPECT_EQ(result.statistics.total().splits, 0U);
    EXPECT_EQ(result.statistics.total().planes, 0U);
    EXPECT_EQ(result.statistics.total().faces_at_once, 6U);
}

/// While two levels blend the finer is in front, even where it lies inside the coarser; nothing else changes its place.
TEST(Details, TheFinerOfTwoThatBlendComesFirstFromEveryEye) {
    const CompileResult result = compile_text(scene(
        detail("to_m = [100, 200]\nblend_m = 40\n") + level_box("coarse", 1, 4) + level_box("fine", 0, 3) +
        "[[object]]\nname = \"mast\"\nlist = \"list\"\ncolour = \"grey\"\n"
        "[[object.box]]\nfrom_m = [6, -0.5, -5]\nto_m = [7, 0.5, 9]\n"));
    ASSERT_TRUE(result.database) << messages(result);
    const VisualDatabase& d = *result.database;
    EXPECT_EQ(result.statistics.total().faces_at_once, 18U);
    Random random(4);
    for (int e = 0; e < 200; ++e) {
        const Vec3d eye = random.point({-40, -40, -40}, {40, 40, 40});
        if (std::max({std::fabs(eye.x), std::fabs(eye.y), std::fabs(eye.z)}) < 10) continue;
        std::vector<std::uint32_t> order;
        walk(d, d.lists[0].root, eye, order);
        int met_coarse = 0;
        for (const std::uint32_t f : order) {
            const std::int32_t level = d.objects[d.faces[f].object].level;
            met_coarse += level == 1 ? 1 : 0;
            EXPECT_FALSE(level == 0 && met_coarse > 0);
        }
    }
}

/// The mast stands before and behind the levels; rays see it in its place whichever level is there.
TEST(Details, WhatHasNoLevelKeepsItsPlaceAmongThem) {
    const std::vector<Solid> solids = {box({5, -1, -4}, {6, 1, 8}), box({-7, -1, -4}, {-6, 1, 8}),
                                       box({-2, 5, -1}, {2, 7, 1})};
    std::string text = detail("to_m = [100, 200]\nblend_m = 40\n") + level_box("coarse", 1, 3.5);
    for (std::size_t i = 0; i < solids.size(); ++i)
        text += fmt::format("[[object]]\nname = \"s{}\"\nlist = \"list\"\ncolour = \"grey\"\n{}", i,
                            solids[i].text);
    const CompileResult result = compile_text(scene(text + level_box("fine", 0, 2.5)));
    ASSERT_TRUE(result.database) << messages(result);
    const VisualDatabase& d = *result.database;
    const auto without_levels = [&](std::int32_t root, const Vec3d& eye) {
        std::vector<std::uint32_t> order;
        walk(d, root, eye, order);
        std::erase_if(order, [&](std::uint32_t f) { return d.objects[d.faces[f].object].level != none; });
        return order;
    };
    Random random(11);
    int hits = 0;
    for (int e = 0; e < 200; ++e) {
        const Vec3d eye = random.point({-30, -30, -30}, {30, 30, 30});
        if (std::max({std::fabs(eye.x), std::fabs(eye.y), std::fabs(eye.z)}) < 9) continue;
        const std::vector<std::uint32_t> order = without_levels(d.lists[0].root, eye);
        for (int r = 0; r < 40; ++r) {
            const Ray ray{eye, glm::normalize(random.point({-8, -8, -8}, {8, 8, 8}) - eye)};
            const Met met = met_in_order(d, order, ray);
            if (!met.clearly()) continue;
            ++hits;
            EXPECT_LT(met.first - met.nearest, 1e-2);
        }
    }
    EXPECT_GT(hits, 1000);
}

TEST(Details, AddedLevelsAreAllThereAtOnce) {
    const CompileResult result = compile_text(scene(detail("to_m = [100, 200]\nadded = true\n") +
                                                    level_box("inner", 0, 1) + level_box("outer", 1, 2)));
    ASSERT_TRUE(result.database) << messages(result);
    EXPECT_EQ(result.database->details[0].added, 1);
    EXPECT_EQ(result.statistics.total().faces_at_once, 12U);
    EXPECT_EQ(summarise(*result.database).lists[0].faces_at_most, 12U);
}

TEST(Details, MistakesInTheRanges) {
    const std::string objects = level_box("a", 0, 1) + level_box("b", 1, 2);
    EXPECT_THAT(
        said(detail("to_m = [100, 100]\n") + objects),
        HasSubstr("root.toml:19: level 1 reaches to 100 m and the one before to 100 m: it is never seen; "
                  "expected ascending ranges\n"));
    EXPECT_THAT(
        said(detail("to_m = [100, 130]\nblend_m = 40\n") + objects),
        HasSubstr("root.toml:19: level 1 ends at 130 m, where the change before it is not over: blend_m or "
                  "hysteresis_m is 40 m; expected deeper levels\n"));
    EXPECT_THAT(said(detail("to_m = [100, 200]\nblend_m = 40\nhysteresis_m = 4\n") + objects),
                HasSubstr("root.toml:21: \"hysteresis_m\" stands beside \"blend_m\"; expected one"));
    for (const char* wrong :
         {"to_m = []\n", "to_m = [0, 5]\n", "to_m = [1, nan]\n", "to_m = [1, inf]\n", "to_m = 7\n",
          "to_m = ['x']\n", "to_m = [1, 2e7]\n", "to_m = [1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17]\n"})
        EXPECT_THAT(said(detail(wrong) + objects),
                    HasSubstr("\"to_m\" lists no ranges; expected 1 to 16 lengths"));
    EXPECT_THAT(said(detail("") + objects), HasSubstr("root.toml:15: \"to_m\" lists no ranges"));
}

TEST(Details, MistakesInTheLevels) {
    const std::string two = detail("to_m = [100, 200]\n");
    EXPECT_EQ(said(two + level_box("a", 0, 1)),
              "root.toml:15: no object is level 1 of detail \"d\"; expected at least one\n");
    EXPECT_EQ(said(two + level_box("a", 0, 1) + level_box("b", 1, 1) + level_box("c", 2, 1)),
              "root.toml:38: object \"c\" is level 2 of detail \"d\", which has 2; expected 0 to 1\n");
    EXPECT_EQ(said("[[object]]\nname = \"o\"\nlist = \"list\"\ncolour = \"grey\"\nlevel = 0\n"
                   "[[object.box]]\nfrom_m = [0, 0, 0]\nto_m = [1, 1, 1]\n"),
              "root.toml:19: \"level\" stands without \"detail\"; expected both or neither\n");
    EXPECT_THAT(
        said("[[object]]\nname = \"o\"\nlist = \"list\"\ncolour = \"grey\"\ndetail = \"e\"\nlevel = 0\n"
             "[[object.box]]\nfrom_m = [0, 0, 0]\nto_m = [1, 1, 1]\n"),
        HasSubstr("root.toml:19: no detail is named \"e\"; expected a [[detail]] of that name"));
    EXPECT_THAT(
        said(two + level_box("a", 0, 1) + level_box("b", 1, 1) +
             "[[cluster]]\nname = \"other\"\npriority = 2\n[[object_list]]\nname = \"far\"\n"
             "cluster = \"other\"\nsun = \"sun\"\n[[object]]\nname = \"c\"\nlist = \"far\"\ncolour = "
             "\"grey\"\n"
             "detail = \"d\"\nlevel = 1\n[[object.box]]\nfrom_m = [0, 0, 0]\nto_m = [1, 1, 1]\n"),
        HasSubstr(
            "the detail \"d\" belongs to the cluster \"cluster\", the object to \"other\"; expected one "
            "cluster"));
    EXPECT_THAT(said(two + detail("to_m = [5]\n") + level_box("a", 0, 1) + level_box("b", 1, 1)),
                HasSubstr("root.toml:20: the detail \"d\" stands already in"));
}

} // namespace
} // namespace linkdig::database
