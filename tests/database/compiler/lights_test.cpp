/// Light points: what the author writes, and their place among the faces against rays.

#include "tests/database/compiler/solids.h"

#include "database/format/validate.h"
#include "database/model/mathematics.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

namespace linkdig::database {
namespace {

using testing::HasSubstr;

std::string object(const std::string& lights) {
    return "[[object]]\nname = \"o\"\nlist = \"list\"\n" + lights;
}

TEST(Lights, AreReadAsWritten) {
    const CompileResult result = compile_text(
        scene(object("[[object.light]]\nposition_m = [1, 2, 3]\ncolour = \"grey\"\n"
                     "[[object.light]]\nposition_ft = [10, 0, 0]\ncolour = \"grey\"\nbeam = "
                     "\"two_way\"\nback_colour = \"grey\"\n"
                     "direction = [0, 2, 0]\nhalf_angle_deg = 45\nvertical_half_angle_deg = 5\nintensity = "
                     "3\nsize_m = 0.4\n"
                     "full_to_m = 500\nfall_off = \"square\"\nflash_hz = 1.5\nduty = 0.2\nphase = 0.25\n")));
    ASSERT_TRUE(result.database) << messages(result);
    const VisualDatabase& d = *result.database;
    EXPECT_EQ(validate(d), "");
    ASSERT_EQ(d.lights.size(), 2U);
    EXPECT_EQ(result.statistics.total().lights, 2U);
    EXPECT_EQ(d.lights[0].position, Vec3f(1, 2, 3));
    EXPECT_EQ(d.lights[0].beam, LightBeam::all_round);
    EXPECT_EQ(d.lights[0].line, 18U);
    const LightPoint& light = d.lights[1];
    EXPECT_FLOAT_EQ(light.position.x, 3.048F);
    EXPECT_EQ(light.beam, LightBeam::two_way);
    EXPECT_EQ(light.direction, Vec3f(0, 1, 0));
    EXPECT_EQ(std::fabs(light.side.x), 1.0F);
    EXPECT_NEAR(light.across, 1.0, 1e-6);
    EXPECT_NEAR(light.upward, 1.0 / std::pow(std::tan(radians(5.0)), 2), 1e-3);
    EXPECT_EQ(light.intensity, 3.0F);
    EXPECT_EQ(light.size_m, 0.4F);
    EXPECT_EQ(light.full_to_m, 500.0F);
    EXPECT_EQ(light.fall_off, FallOff::square);
    EXPECT_EQ(light.flash_hz, 1.5F);
    EXPECT_EQ(light.duty, 0.2F);
    EXPECT_EQ(light.phase, 0.25F);
    ASSERT_EQ(d.runs.size(), 1U) << "one run without faces";
    EXPECT_EQ(d.runs[0].light_count, 2U);
    EXPECT_EQ(d.runs[0].face_count, 0U);
    for (const LightPoint& each : d.lights)
        EXPECT_LE(glm::distance(each.position, d.runs[0].centre), d.runs[0].radius);
}

TEST(Lights, StringsDivideTheirLineAndRunTheirPhases) {
    const CompileResult result = compile_text(scene(object(
        "colour = \"grey\"\nmirror = \"y\"\n[[object.light_string]]\nfrom_m = [0, 5, 0]\nto_m = [90, 5, 9]\n"
        "count = 10\nflash_hz = 2\nphase = 0.9\nphase_step = -0.25\n")));
    ASSERT_TRUE(result.database) << messages(result);
    const VisualDatabase& d = *result.database;
    ASSERT_EQ(d.lights.size(), 20U);
    int port = 0;
    for (const LightPoint& light : d.lights) {
        const int k = static_cast<int>(std::lround(light.position.x / 10.0F));
        EXPECT_FLOAT_EQ(light.position.x, 10.0F * static_cast<float>(k));
        EXPECT_FLOAT_EQ(light.position.z, static_cast<float>(k));
        EXPECT_EQ(std::fabs(light.position.y), 5.0F);
        port += light.position.y > 0.0F ? 1 : 0;
        const double phase = 0.9 - 0.25 * k;
        EXPECT_NEAR(light.phase, phase - std::floor(phase), 1e-6);
    }
    EXPECT_EQ(port, 10);
}

TEST(Lights, MistakesAreTold) {
    const auto said = [](const std::string& keys) {
        const CompileResult result = compile_text(scene(object("[[object.light]]\n" + keys + "\n")));
        EXPECT_FALSE(result.database) << keys;
        return messages(result);
    };
    const std::string at = "position_m = [0, 0, 0]\n";
    const std::string grey = at + "colour = \"grey\"\n";
    EXPECT_THAT(said(at), HasSubstr("has no colour; expected `colour` here or in the object"));
    EXPECT_EQ(said("colour = \"gray\"\n" + at),
              "root.toml:19: no colour is named \"gray\"; did you mean \"grey\"?\n");
    EXPECT_THAT(said("colour = \"grey\""), HasSubstr("position_m"));
    EXPECT_THAT(said(grey + "half_angle_deg = 20"), HasSubstr("stands in a light that shines all round"));
    EXPECT_THAT(said(grey + "beam = \"one_way\""), HasSubstr("direction"));
    EXPECT_THAT(said(grey + "beam = \"one_way\"\ndirection = [0, 0, 0]"), HasSubstr("has no length"));
    EXPECT_THAT(said(grey + "beam = \"one_way\"\ndirection = [1, 0, 0]\nhalf_angle_deg = 90"),
                HasSubstr("0.5 to 85"));
    EXPECT_THAT(said(grey + "beam = \"one_way\"\ndirection = [1, 0, 0]\nback_colour = \"grey\""),
                HasSubstr("without a second beam"));
    EXPECT_THAT(said(grey + "beam = \"sideways\""), HasSubstr("all_round"));
    EXPECT_THAT(said(grey + "duty = 1.5"), HasSubstr("duty"));
    EXPECT_THAT(said(grey + "intensty = 1"), HasSubstr("intensity"));
    EXPECT_THAT(said("colour = \"grey\"\nposition_m = [0, 0, 2e7]"),
                HasSubstr("a light of object \"o\" lies beyond"));
    const CompileResult one = compile_text(scene(object(
        "colour = \"grey\"\n[[object.light_string]]\nfrom_m = [0, 0, 0]\nto_m = [1, 0, 0]\ncount = 1\n")));
    EXPECT_THAT(messages(one), HasSubstr("\"count\" is 1"));
}

TEST(Lights, OfASlotStandInItsRuns) {
    std::string text = "[[slot]]\nname = \"s\"\nalternatives = 2\n";
    for (int i = 0; i < 2; ++i)
        text += fmt::format("[[object]]\nname = \"o{0}\"\nlist = \"list\"\ncolour = \"grey\"\nslot = \"s\"\n"
                            "alternative = {0}\n[[object.light]]\nposition_m = [{0}, 0, 0]\n",
                            i);
    const CompileResult result = compile_text(scene(text));
    ASSERT_TRUE(result.database) << messages(result);
    EXPECT_EQ(validate(*result.database), "");
    ASSERT_EQ(result.database->runs.size(), 2U);
    for (const FaceRun& run : result.database->runs)
        EXPECT_EQ(result.database->lights[run.first_light].position.x, static_cast<float>(run.alternative));
}

// ---- order ------------------------------------------------------------------------------------------------------------

struct Item {
    bool is_light;
    std::uint32_t index;
};

/// Faces and light points of the list, front to back.
void walk_all(const VisualDatabase& d, std::int32_t reference, const Vec3d& eye, std::vector<Item>& items) {
    if (reference == none) return;
    if (is_leaf(reference)) {
        const RunLeaf& leaf = d.run_leaves[leaf_index(reference)];
        for (std::uint32_t r = leaf.first_run; r < leaf.first_run + leaf.run_count; ++r) {
            const FaceRun& run = d.runs[r];
            for (std::uint32_t place = 0; place <= run.face_count; ++place) {
                for (std::uint32_t l = run.first_light; l < run.first_light + run.light_count; ++l)
                    if (d.lights[l].place == place) items.push_back({true, l});
                if (place < run.face_count) items.push_back({false, run.first_face + place});
            }
        }
        return;
    }
    const PlaneNode& node = d.planes[static_cast<std::size_t>(reference)];
    const bool front = glm::dot(Vec3d(node.normal), eye) > static_cast<double>(node.distance);
    walk_all(d, front ? node.front : node.back, eye, items);
    walk_all(d, node.on, eye, items);
    walk_all(d, front ? node.back : node.front, eye, items);
}

/// Lights in the air, in the middle of tops, and one-way ones against walls.
std::string random_lights(Random& random, const std::vector<Solid>& solids) {
    std::string text = "[[object]]\nname = \"lights\"\nlist = \"list\"\ncolour = \"grey\"\n";
    for (int k = 0; k < 12; ++k) {
        const Vec3d p = random.point({-12, -12, -12}, {12, 12, 12});
        text += fmt::format("[[object.light]]\nposition_m = [{}, {}, {}]\n", p.x, p.y, p.z);
    }
    for (const Solid& solid : solids) {
        const Vec3d middle = 0.5 * (solid.low + solid.high);
        text +=
            fmt::format("[[object.light]]\nposition_m = [{}, {}, {}]\n", middle.x, middle.y, solid.high.z);
        text += fmt::format(
            "[[object.light]]\nposition_m = [{}, {}, {}]\nbeam = \"one_way\"\ndirection = [0, 0, 1]\n",
            middle.x, middle.y, solid.high.z + 0.02);
    }
    return text;
}

struct LightTally {
    int seen = 0;
    int hidden = 0;
    int wrong = 0;
};

/// A light is seen if and only if no face that the ray to it meets stands before it in the order.
void check_lights(const VisualDatabase& d, Random& random, int eyes, LightTally& tally) {
    for (int e = 0; e < eyes; ++e) {
        const Vec3d eye = random.point({-40, -40, -40}, {40, 40, 40});
        std::vector<Item> items;
        walk_all(d, d.lists[0].root, eye, items);
        for (std::size_t k = 0; k < items.size(); ++k) {
            if (!items[k].is_light) continue;
            const LightPoint& light = d.lights[items[k].index];
            const Vec3d to_light = Vec3d(light.position) - eye;
            if (light.beam == LightBeam::one_way && glm::dot(to_light, Vec3d(light.direction)) > -0.1)
                continue;
            const double range = glm::length(to_light);
            const Ray ray{eye, to_light / range};
            bool found = false, expected = false;
            double margin = 1e300;
            for (std::size_t f = 0; f < items.size(); ++f) {
                if (items[f].is_light) continue;
                double distance = 0;
                if (!meets(d, d.faces[items[f].index], ray, distance, margin)) continue;
                found = found || f < k;
                expected = expected || distance < range - 0.002;
                if (std::fabs(distance - range) < 0.05 && std::fabs(distance - range) > 0.002) margin = 0.0;
            }
            if (margin < 2e-3) continue; // by a hair: either answer is right
            tally.wrong += found != expected ? 1 : 0;
            ++(expected ? tally.hidden : tally.seen);
        }
    }
}

TEST(LightOrder, AmongRandomSolidsIsThatOfRays) {
    LightTally tally;
    for (std::uint64_t seed = 1; seed <= 25; ++seed) {
        Random random(seed);
        const std::vector<Solid> solids = random_solids(random, 3 + static_cast<int>(seed) / 2);
        std::string text;
        for (std::size_t i = 0; i < solids.size(); ++i)
            text += fmt::format("[[object]]\nname = \"s{}\"\nlist = \"list\"\ncolour = \"grey\"\n{}", i,
                                solids[i].text);
        const CompileResult result = compile_text(scene(text + random_lights(random, solids)));
        ASSERT_TRUE(result.database) << messages(result);
        ASSERT_EQ(validate(*result.database), "");
        ASSERT_EQ(result.database->lights.size(), 12 + 2 * solids.size());
        check_lights(*result.database, random, 60, tally);
    }
    EXPECT_EQ(tally.wrong, 0) << "of " << tally.seen + tally.hidden;
    EXPECT_GT(tally.seen, 5000);
    EXPECT_GT(tally.hidden, 5000);
}

TEST(LightOrder, ALightOnADeckIsInFrontOfItAndOfWhatIsPaintedOnIt) {
    const CompileResult result = compile_text(scene(
        "[[object]]\nname = \"deck\"\nlist = \"list\"\ncolour = \"grey\"\n[[object.box]]\nfrom_m = [-9, -9, "
        "-2]\n"
        "to_m = [9, 9, 0]\n[[object]]\nname = \"mark\"\nlist = \"list\"\ncolour = \"grey\"\nlayer = 3\n"
        "[[object.disc]]\ncentre_m = [0, 0, 0]\nradius_m = 2\n[[object]]\nname = \"lamp\"\nlist = \"list\"\n"
        "colour = \"grey\"\n[[object.light]]\nposition_m = [0, 0, 0]\n"));
    ASSERT_TRUE(result.database) << messages(result);
    const VisualDatabase& d = *result.database;
    EXPECT_EQ(result.statistics.total().splits, 0U);
    std::vector<Item> items;
    walk_all(d, d.lists[0].root, {3, 4, 20}, items);
    const auto lamp = std::ranges::find_if(items, [](const Item& item) { return item.is_light; });
    for (auto item = items.begin(); item != lamp; ++item)
        EXPECT_LT(d.faces[item->index].normal.z, 0.9F) << "nothing that looks up stands before it";
}

TEST(LightOrder, AHundredThousandLightsCompile) {
    std::string text =
        "[[object]]\nname = \"ground\"\nlist = \"list\"\ncolour = \"grey\"\n[[object.rectangle]]\n"
        "centre_m = [0, 0, 0]\nsize_m = [9000, 900]\n[[object]]\nname = \"lamps\"\nlist = \"list\"\n"
        "colour = \"grey\"\n[[object.light_string]]\nfrom_m = [-4000, 0, 0]\nto_m = [4000, 0, 0]\n"
        "count = 100000\n";
    const CompileResult result = compile_text(scene(text));
    ASSERT_TRUE(result.database) << messages(result);
    EXPECT_EQ(result.database->lights.size(), 100000U);
    EXPECT_EQ(validate(*result.database), "");
}

} // namespace
} // namespace linkdig::database
