// linkdig check: right databases pass, wrong priorities are found by name, what differs by design is counted.

#include "tools/check/caster.h"
#include "tools/check/check.h"

#include "database/compiler/compile.h"
#include "tests/database/compiler/authored.h"
#include "tools/flight/bad_input.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace linkdig::tools {
namespace {

using testing::HasSubstr;

/// A shed and a tower 10 m behind it, in two lists of one cluster; `lists` gives their priorities, `planes` their plane.
std::string yard(const std::string& shed_priority, const std::string& tower_priority,
                 const std::string& planes) {
    return "[database]\nname = \"yard\"\n[[colour]]\nname = \"grey\"\nrgb = [128, 128, 128]\n"
           "[[sun]]\nname = \"sun\"\n[[cluster]]\nname = \"yard\"\npriority = 1\n"
           "[[object_list]]\nname = \"shed\"\ncluster = \"yard\"\nsun = \"sun\"\npriority = " +
           shed_priority +
           "\n[[object_list]]\nname = \"tower\"\ncluster = \"yard\"\nsun = \"sun\"\npriority = " +
           tower_priority + "\n" + planes +
           "\n[[object]]\nname = \"the shed\"\nlist = \"shed\"\ncolour = \"grey\"\n"
           "[[object.box]] # shed\nfrom_m = [0, 0, 0]\nto_m = [10, 20, 6]\n"
           "[[object]]\nname = \"the tower\"\nlist = \"tower\"\ncolour = \"grey\"\n"
           "[[object.box]] # tower\nfrom_m = [20, 5, 0]\nto_m = [26, 11, 25]\n";
}

std::string plane(const char* front, const char* back) {
    return std::string("[[cluster_plane]]\ncluster = \"yard\"\nname = \"between\"\nnormal = [1, 0, 0]\n"
                       "distance_m = 15\nfront = \"") +
           front + "\"\nback = \"" + back + "\"";
}

std::uint32_t line_of(const std::string& text, const std::string& words) {
    return 1 + static_cast<std::uint32_t>(std::count(
                   text.begin(), text.begin() + static_cast<std::ptrdiff_t>(text.find(words)), '\n'));
}

VisualDatabase compiled(const std::string& text) {
    database::CompileResult result = database::compile_text(text);
    EXPECT_TRUE(result.database) << result.diagnostics.text();
    return result.database ? *std::move(result.database) : VisualDatabase{};
}

CheckRequest small_request(std::uint64_t views) {
    CheckRequest request;
    request.views = views;
    request.raster = {128, 128, ig::Scan::horizontal};
    return request;
}

TEST(Check, ARightPlaneHasNoWrongPixel) {
    const CheckResult result =
        check_database(compiled(yard("0", "0", plane("tower", "shed"))), small_request(24));
    EXPECT_EQ(result.views, 24U);
    EXPECT_GT(result.interior, 24U * 128 * 128 / 2);
    EXPECT_EQ(result.wrong, 0U);
}

/// Both faces of the finding are named as they were authored.
void expect_shed_over_tower(const std::string& text, const CheckResult& result) {
    ASSERT_FALSE(result.findings.empty());
    EXPECT_GT(result.wrong_share(), 0.0005);
    const bool found = std::ranges::any_of(result.findings, [&](const Finding& finding) {
        return finding.shown ==
                   FacePlace{"shed", "the shed", "root.toml", line_of(text, "[[object.box]] # shed")} &&
               finding.nearest ==
                   FacePlace{"tower", "the tower", "root.toml", line_of(text, "[[object.box]] # tower")} &&
               finding.nearer_by_m > 9.9 && finding.nearer_by_m < 1000.0;
    });
    EXPECT_TRUE(found);
}

TEST(Check, AWrongNumberIsFoundByName) {
    const std::string text = yard("1", "2", ""); // the shed is always in front
    expect_shed_over_tower(text, check_database(compiled(text), small_request(24)));
}

TEST(Check, AWrongPlaneIsFoundByName) {
    const std::string text = yard("0", "0", plane("shed", "tower")); // its sides are exchanged
    expect_shed_over_tower(text, check_database(compiled(text), small_request(24)));
}

TEST(Check, AViewCanBeSeenAgain) {
    const VisualDatabase database = compiled(yard("1", "2", ""));
    const CheckResult all = check_database(database, small_request(24));
    ASSERT_FALSE(all.findings.empty());
    CheckRequest one = small_request(1);
    one.first_view = all.findings[0].view;
    const CheckResult again = check_database(database, one);
    ASSERT_FALSE(again.findings.empty());
    const bool same = std::ranges::any_of(again.findings, [&](const Finding& finding) {
        return finding.column == all.findings[0].column && finding.row == all.findings[0].row;
    });
    EXPECT_TRUE(same);
}

TEST(Check, NothingIsNoProof) {
    EXPECT_THAT(
        [] { check_database(compiled(yard("1", "2", "")), small_request(0)); },
        testing::ThrowsMessage<BadInput>(HasSubstr("nothing was checked: no pixel of 0 views of 128 x 128")));
}

TEST(Check, WhatDiffersByDesignIsCountedAndNotWrong) {
    const VisualDatabase database = compiled(yard("1", "2", ""));
    const database::ScratchFolder folder;
    const std::string manifest = folder.write(
        "check.toml",
        "[[exception]]\nfront = [\"shed\"]\nbehind = [\"tower\"]\nreason = \"it is drawn last\"\n");
    EXPECT_EQ(manifest_beside(folder.path() + "/yard.toml"), manifest);
    CheckRequest request = small_request(24);
    request.exceptions = read_exceptions(manifest, database);
    const CheckResult result = check_database(database, request);
    EXPECT_EQ(result.wrong, 0U);
    ASSERT_EQ(result.excepted.size(), 1U);
    EXPECT_GT(result.excepted[0], 100U);
}

/// An exception that reaches only so far: what is farther than that behind the nearer face stays wrong.
TEST(Check, AnExceptionMayHaveALimit) {
    const VisualDatabase database = compiled(yard("1", "2", ""));
    const database::ScratchFolder folder;
    const auto wrong_with = [&](double by_at_most_m) {
        CheckRequest request = small_request(24);
        request.exceptions = read_exceptions(
            folder.write("check.toml", fmt::format("[[exception]]\nfront = [\"shed\"]\nbehind = [\"tower\"]\n"
                                                   "by_at_most_m = {}\nreason = \"it is drawn last\"\n",
                                                   by_at_most_m)),
            database);
        const CheckResult result = check_database(database, request);
        for (const Finding& finding : result.findings)
            EXPECT_GT(finding.nearer_by_m, by_at_most_m);
        return result.wrong;
    };
    EXPECT_GT(wrong_with(0.0), wrong_with(20.0));
    EXPECT_GT(wrong_with(20.0), 0U);
    EXPECT_EQ(wrong_with(1000.0), 0U);
}

TEST(Check, AManifestThatNamesNothingIsRefused) {
    const VisualDatabase database = compiled(yard("1", "2", ""));
    const database::ScratchFolder folder;
    const std::string manifest =
        folder.write("check.toml", "[[exception]]\nfront = [\"shedd\"]\nreason = \"none\"\nbecause = 1\n");
    try {
        read_exceptions(manifest, database);
        FAIL() << "the manifest was taken";
    } catch (const BadInput& mistakes) {
        EXPECT_THAT(mistakes.what(), HasSubstr("check.toml:2:9: error: no object list or cluster is named "
                                               "\"shedd\"; did you mean \"shed\"?"));
        EXPECT_THAT(mistakes.what(), HasSubstr("\"behind\" is missing; expected an array of names"));
        EXPECT_THAT(mistakes.what(), HasSubstr("because"));
    }
    EXPECT_EQ(manifest_beside(folder.path() + "/nowhere/yard.toml"), "");
}

/// The caster against an answer known beforehand.
TEST(Check, TheCasterKnowsABox) {
    const VisualDatabase database = compiled(yard("1", "2", ""));
    FramePacket packet;
    packet.suns = {{0, 0, 1}};
    const CastScene scene = cast_scene(database, packet, {-30, 10, 3});
    const Caster caster(scene);
    EXPECT_FALSE(caster.eye_is_inside());
    std::vector<CastHit> hits;
    caster.all({1, 0, 0}, 0.25,
               hits); // the shed's near wall at 30 m, the tower's at 50 m; far walls face away
    ASSERT_EQ(hits.size(), 2U);
    EXPECT_NEAR(hits[0].range_m, 30.0, 1e-9);
    EXPECT_NEAR(hits[1].range_m, 50.0, 1e-9);
    caster.nearest({1, 0, 0}, 0.25, hits);
    EXPECT_EQ(hits.size(), 1U);
    caster.nearest({1, 0, 0}, 30.5, hits); // a near plane behind the first
    ASSERT_EQ(hits.size(), 1U);
    EXPECT_NEAR(hits[0].range_m, 50.0, 1e-9);
    caster.nearest({-1, 0, 0}, 0.25, hits);
    EXPECT_TRUE(hits.empty());
    const CastScene within = cast_scene(database, packet, {5, 10, 3});
    EXPECT_TRUE(Caster(within).eye_is_inside());
}

/// A field that reaches from a shore to the horizon: its near edge is where it is written, though its far one is at infinity.
TEST(Check, TheCasterKnowsTheNearEdgeOfAFieldWithoutEnd) {
    const VisualDatabase database =
        compiled("[database]\nname = \"shore\"\n[[colour]]\nname = \"green\"\nrgb = [80, 128, 60]\n"
                 "[[sun]]\nname = \"sun\"\n[[cluster]]\nname = \"shore\"\npriority = 1\n"
                 "[[object_list]]\nname = \"land\"\ncluster = \"shore\"\nsun = \"sun\"\n"
                 "[[object]]\nname = \"field\"\nlist = \"land\"\ncolour = \"green\"\n"
                 "[object.directions]\nwest = [-1, 0, 0]\n"
                 "[object.vertices_m]\nsouthern = [-2600, 6500, 0]\nnorthern = [-1200, 9000, 0]\n"
                 "[[object.face]]\ncorners = [\"west\", \"southern\", \"northern\"]\n");
    FramePacket packet;
    packet.suns = {{0, 0, 1}};
    const Vec3d eye(-2413.5, 7810.5, 236.2); // over the field, its shore 550 m to the east
    const CastScene scene = cast_scene(database, packet, eye);
    const Caster caster(scene);
    EXPECT_FALSE(caster.eye_is_inside());
    const auto meets = [&](const Vec3d& point) {
        std::vector<CastHit> hits;
        caster.nearest(glm::normalize(point - eye), 0.25, hits);
        if (!hits.empty()) {
            EXPECT_NEAR(hits.front().range_m, glm::distance(point, eye), 1e-6);
        }
        return !hits.empty();
    };
    for (double part = 0.01; part < 1.0; part += 0.07) {
        const Vec3d shore(-2600.0 + 1400.0 * part, 6500.0 + 2500.0 * part, 0.0);
        EXPECT_TRUE(meets(shore - Vec3d(0.01, 0, 0))) << part;
        EXPECT_FALSE(meets(shore + Vec3d(0.01, 0, 0))) << part;
    }
    EXPECT_TRUE(meets({-1e7, 8000, 0}));
    EXPECT_FALSE(meets({-1e7, 9000.5, 0}));
    const CastScene below = cast_scene(database, packet, {-2413.5, 7810.5, -1.0});
    EXPECT_TRUE(Caster(below).eye_is_inside());
}

/// Every database that ships, from a few views; the long form is a test of its own (`check.long.NAME`).
TEST(Check, ShippedDatabasesShowWhatIsNearest) {
    int checked = 0;
    for (const auto& folder : std::filesystem::directory_iterator(LINKDIG_SOURCE_DIR "/database/scenes")) {
        for (const auto& file : std::filesystem::directory_iterator(folder.path())) {
            std::ostringstream text;
            text << std::ifstream(file.path()).rdbuf();
            if (text.str().find("\n[database]") == std::string::npos) continue;
            SCOPED_TRACE(file.path().filename().string());
            const database::CompileResult result = database::compile_file(file.path().string());
            ASSERT_TRUE(result.database) << result.diagnostics.text();
            CheckRequest request = small_request(12);
            request.raster = {256, 256, ig::Scan::horizontal};
            if (const std::string manifest = manifest_beside(file.path().string()); !manifest.empty())
                request.exceptions = read_exceptions(manifest, *result.database);
            const CheckResult checked_views = check_database(*result.database, request);
            EXPECT_LE(checked_views.wrong_share(), 0.0005)
                << checked_views.wrong << " wrong pixels; linkdig check " << file.path().string()
                << " names them";
            EXPECT_GT(checked_views.interior, 0U);
            ++checked;
        }
    }
    EXPECT_GE(checked, 2);
}

} // namespace
} // namespace linkdig::tools
