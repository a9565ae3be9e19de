/// What a cut leaves: the same surface, closed, with the same object, line and intensity.

#include "tests/database/compiler/solids.h"

#include <array>
#include <cmath>
#include <map>
#include <tuple>

namespace linkdig::database {
namespace {

using Place = std::array<float, 3>;

/// Closed solids stay closed however they are cut: each edge is used once in either direction, point by
/// point.
TEST(FaceCutting, CutFacesLeaveNoGap) {
    for (std::uint64_t seed = 50; seed < 60; ++seed) {
        Random random(seed);
        std::vector<Solid> solids = random_solids(random, 30);
        if (seed == 50) solids = interlocked_beams();
        const CompileResult result = compiled(solids);
        const VisualDatabase& d = *result.database;
        std::map<std::tuple<std::uint32_t, Place, Place>, int> edges;
        for (const Face& face : d.faces)
            for (std::uint32_t i = 0; i < face.corner_count; ++i) {
                const auto place = [&](std::uint32_t corner) {
                    const Vec4f& p =
                        d.vertices[d.corners[face.first_corner + corner % face.corner_count]].position;
                    return Place{p.x, p.y, p.z};
                };
                ++edges[{face.object, place(i), place(i + 1)}];
            }
        for (const auto& [edge, uses] : edges) {
            const auto& [object, from, to] = edge;
            const auto opposite = edges.find({object, to, from});
            ASSERT_NE(opposite, edges.end()) << "seed " << seed;
            ASSERT_EQ(uses, opposite->second) << "seed " << seed;
        }
    }
}

TEST(FaceCutting, CutsKeepAreaObjectLineAndIntensity) {
    // Two boxes through each other, smooth-shaded: a corner's normal is radial, and every cut point's lies
    // between.
    const std::string text =
        scene("[[object]]\nname = \"o\"\nlist = \"list\"\ncolour = \"grey\"\nshading = "
              "\"vertex\"\n[[object.box]]\nfrom_m = [-3, -1, -1]\nto_m = [3, 1, 1]\n"
              "[[object]]\nname = \"p\"\nlist = \"list\"\ncolour = \"grey\"\nshading = "
              "\"vertex\"\n[[object.box]]\nfrom_m = [-0.5, -3, -0.5]\nto_m = [0.5, 3, 0.5]\n");
    const CompileResult result = compile_text(text);
    ASSERT_TRUE(result.database) << messages(result);
    const VisualDatabase& d = *result.database;
    EXPECT_GT(result.statistics.total().splits, 0U);
    std::map<std::uint32_t, double> area;
    for (const Face& face : d.faces) {
        const auto corner = [&](std::uint32_t i) -> const Vertex& {
            return d.vertices[d.corners[face.first_corner + i]];
        };
        for (std::uint32_t i = 1; i + 1 < face.corner_count; ++i)
            area[face.object] +=
                0.5 * glm::length(glm::cross(Vec3d(corner(i).position) - Vec3d(corner(0).position),
                                             Vec3d(corner(i + 1).position) - Vec3d(corner(0).position)));
        EXPECT_EQ(face.line, face.object == 0 ? 20U : 28U);
        for (std::uint32_t i = 0; i < face.corner_count; ++i) {
            const Vec3d half = face.object == 0 ? Vec3d(3, 1, 1) : Vec3d(0.5, 3, 0.5);
            const Vec3d position(corner(i).position);
            int on_sides = 0;
            for (int axis = 0; axis < 3; ++axis)
                on_sides += std::fabs(std::fabs(position[axis]) - half[axis]) < 1e-6 ? 1 : 0;
            const double length = glm::length(Vec3d(corner(i).normal));
            EXPECT_LE(length, 1 + 1e-6);
            EXPECT_TRUE(on_sides < 3 || length > 1 - 1e-6);
            if (on_sides < 2) continue; // in the middle of a face
            // Along an edge the normal's component on the edge's axis is linear from -k to k.
            for (int axis = 0; axis < 3; ++axis)
                EXPECT_NEAR(corner(i).normal[axis], position[axis] / half[axis] / std::sqrt(3.0), 1e-5);
        }
    }
    EXPECT_NEAR(area[0], 2 * (6 * 2 + 6 * 2 + 2 * 2), 1e-3);
    EXPECT_NEAR(area[1], 2 * (1 * 6 + 6 * 1 + 1 * 1), 1e-3);
}

} // namespace
} // namespace linkdig::database
