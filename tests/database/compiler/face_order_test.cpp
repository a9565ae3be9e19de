/// The order of faces, against rays that are cut with the solids themselves: the first face in the order that a ray
/// meets is the nearest one, from every eye.

#include "tests/database/compiler/solids.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace linkdig::database {
namespace {

TEST(FaceOrder, OfRandomSolidsIsThatOfRays) {
    Tally tally;
    std::uint32_t split = 0, planes = 0;
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        Random random(seed);
        const std::vector<Solid> solids = random_solids(random, 3 + static_cast<int>(seed));
        const CompileResult result = compiled(solids);
        split += result.statistics.total().splits;
        planes += result.statistics.total().planes;
        check_rays(*result.database, solids, random, 40, tally);
    }
    EXPECT_EQ(tally.wrong, 0) << "of " << tally.rays;
    EXPECT_GT(tally.hits, 20000);
    EXPECT_LT(tally.grazing, tally.rays / 50);
    EXPECT_GT(split, 0U);
    EXPECT_GT(planes, 40U);
}

TEST(FaceOrder, OfInterlockedBeamsIsThatOfRays) {
    Random random(99);
    Tally tally;
    const std::vector<Solid> solids = interlocked_beams();
    const CompileResult result = compiled(solids);
    check_rays(*result.database, solids, random, 1500, tally);
    EXPECT_EQ(tally.wrong, 0) << "of " << tally.rays;
    EXPECT_GT(tally.hits, 5000);
}

/// Boxes that touch and stand on each other: U, L, stairs.
TEST(FaceOrder, OfTouchingSolidsIsThatOfRays) {
    Random random(5);
    Tally tally;
    std::vector<Solid> solids{box({-8, -8, -1}, {8, 8, 0})};
    solids.push_back(box({-6, -6, 0}, {-5, 6, 4}));
    solids.push_back(box({-5, -6, 0}, {5, -5, 4}));
    solids.push_back(box({-5, 5, 0}, {5, 6, 4}));
    for (int step = 0; step < 5; ++step)
        solids.push_back(box({step, -2, 0}, {step + 1.0, 2, 1.0 + step}));
    const CompileResult result = compiled(solids);
    check_rays(*result.database, solids, random, 400, tally);
    EXPECT_EQ(tally.wrong, 0) << "of " << tally.rays;
    EXPECT_GT(tally.hits, 5000);
}

/// Walls without thickness: the brute-force answer is the nearest of all faces as authored.
TEST(FaceOrder, OfTwoSidedWallsIsThatOfRays) {
    Random random(17);
    std::string text;
    for (int i = 0; i < 30; ++i) {
        const Vec3d a = random.point({-8, -8, -8}, {8, 8, 8});
        const Vec3d u = random.point({-5, -5, -5}, {5, 5, 5});
        const Vec3d v = random.point({-5, -5, -5}, {5, 5, 5});
        text +=
            fmt::format("[[object]]\nname = \"w{}\"\nlist = \"list\"\ncolour = \"grey\"\ntwo_sided = true\n"
                        "vertices_m = {{ a = [{}, {}, {}], b = [{}, {}, {}], c = [{}, {}, {}] }}\n"
                        "[[object.face]]\ncorners = [\"a\", \"b\", \"c\"]\n",
                        i, a.x, a.y, a.z, a.x + u.x, a.y + u.y, a.z + u.z, a.x + v.x, a.y + v.y, a.z + v.z);
    }
    const CompileResult result = compile_text(scene(text));
    ASSERT_TRUE(result.database) << messages(result);
    const VisualDatabase& d = *result.database;
    int wrong = 0, hits = 0;
    for (int e = 0; e < 300; ++e) {
        const Vec3d eye = random.point({-30, -30, -30}, {30, 30, 30});
        std::vector<std::uint32_t> order;
        walk(d, d.lists[0].root, eye, order);
        for (int r = 0; r < 40; ++r) {
            const Ray ray{eye, glm::normalize(random.point({-8, -8, -8}, {8, 8, 8}) - eye)};
            const Met met = met_in_order(d, order, ray);
            if (!met.clearly()) continue;
            ++hits;
            wrong += met.first - met.nearest > 1e-2 ? 1 : 0;
        }
    }
    EXPECT_EQ(wrong, 0) << "of " << hits;
    EXPECT_GT(hits, 3000);
}

TEST(FaceOrder, HigherLayersComeFirst) {
    std::string text = "[[object]]\nname = \"deck\"\nlist = \"list\"\ncolour = "
                       "\"grey\"\n[[object.box]]\nfrom_m = [-9, -9, -2]\nto_m = [9, 9, 0]\n";
    for (const int layer : {2, 5, 3, 1, 4})
        text += fmt::format("[[object]]\nname = \"l{}\"\nlist = \"list\"\ncolour = "
                            "\"grey\"\n[[object.disc]]\ncentre_m = [0, 0, 0]\n"
                            "radius_m = {}\nlayer = {}\n",
                            layer, 6 - layer, layer);
    const CompileResult result = compile_text(scene(text));
    ASSERT_TRUE(result.database) << messages(result);
    const VisualDatabase& d = *result.database;
    std::vector<std::uint32_t> order;
    walk(d, d.lists[0].root, {1, 2, 30}, order);
    std::string names;
    for (const std::uint32_t f : order)
        if (d.faces[f].normal.z > 0.9F) names += d.objects[d.faces[f].object].name + " ";
    EXPECT_EQ(names, "l5 l4 l3 l2 l1 deck ");
}

TEST(FaceOrder, AConvexSolidNeedsNoPlane) {
    const CompileResult result = compiled({prism({0, 0, 0}, 5, 3, 40, 0.1)});
    EXPECT_EQ(result.statistics.total().planes, 0U);
    EXPECT_EQ(result.database->run_leaves.size(), 1U);
    EXPECT_EQ(result.database->runs.size(), 1U);
}

TEST(FaceOrder, AlternativesOfASlotNeverMeet) {
    std::string text = "[[slot]]\nname = \"s\"\nalternatives = 6\n";
    for (int i = 0; i < 6; ++i) // they all pass through each other
        text += fmt::format(
            "[[object]]\nname = \"o{}\"\nlist = \"list\"\ncolour = \"grey\"\nslot = \"s\"\nalternative = {}\n"
            "[[object.box]]\nfrom_m = [{}, 0, 0]\nto_m = [{}, 3, 3]\n",
            i, i, -i, i + 1);
    const CompileResult result = compile_text(scene(text));
    ASSERT_TRUE(result.database) << messages(result);
    EXPECT_EQ(result.statistics.total().splits, 0U);
    EXPECT_EQ(result.statistics.total().faces_at_once, 6U);
    EXPECT_EQ(result.database->runs.size(), 6U);
}

} // namespace
} // namespace linkdig::database
