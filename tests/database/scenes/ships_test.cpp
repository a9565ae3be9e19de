// The ships' occulting parts against their hulls: what the comments of their files promise, for every allowed attitude.

#include "database/compiler/compile.h"
#include "database/model/mathematics.h"
#include "database/model/rotation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

namespace linkdig::database {
namespace {

const VisualDatabase& two_ships() {
    static const CompileResult result =
        compile_file(LINKDIG_SOURCE_DIR "/database/scenes/two_ships/two_ships.toml");
    EXPECT_TRUE(result.database) << result.diagnostics.text();
    return *result.database;
}

/// The corners of each face of the objects with these names.
std::vector<std::vector<Vec3d>> faces_of(const VisualDatabase& d, const std::set<std::string>& names) {
    std::vector<std::vector<Vec3d>> faces;
    for (const Face& face : d.faces) {
        if (names.count(d.objects[face.object].name) == 0) continue;
        faces.emplace_back();
        for (std::uint32_t i = 0; i < face.corner_count; ++i)
            faces.back().emplace_back(d.vertices[d.corners[face.first_corner + i]].position);
    }
    return faces;
}

/// Where the faces, turned by pitch and roll about the origin, meet the plane of the water.
std::vector<Vec2d> waterline_of(const std::vector<std::vector<Vec3d>>& faces, const Attitude& attitude) {
    const Mat3d turn = world_from_body(attitude);
    std::vector<Vec2d> points;
    for (const std::vector<Vec3d>& face : faces)
        for (std::size_t i = 0; i < face.size(); ++i) {
            const Vec3d a = turn * face[i], b = turn * face[(i + 1) % face.size()];
            if ((a.z < 0) == (b.z < 0)) continue;
            const Vec3d crossing = a + (a.z / (a.z - b.z)) * (b - a);
            points.emplace_back(crossing.x, crossing.y);
        }
    return points;
}

struct Ship {
    const char* name;
    std::set<std::string> hull;
    double length_m; ///< of the waterline at rest: what a test without points would miss
};

const std::vector<Ship>& ships() {
    static const std::vector<Ship> all{
        {"lph2", {"hull sides", "boot topping", "transom", "lph2 hull below"}, 160},
        {"dd963",
         {"dd963 lower hull", "dd963 hull sides", "dd963 bow strake", "dd963 boot topping", "dd963 transom",
          "dd963 hull below"},
         155}};
    return all;
}

TEST(Ships, TheFittedBoxEnclosesTheWaterplaneAtEveryAllowedAttitude) {
    for (const Ship& ship : ships()) {
        const std::string name = ship.name;
        const auto hull = faces_of(two_ships(), ship.hull);
        const auto walls = faces_of(two_ships(), {name + " fitted box"});
        ASSERT_GE(walls.size(), 8U);
        for (double pitch = -10; pitch <= 10; pitch += 2.5)
            for (double roll = -8; roll <= 8; roll += 4) {
                const auto waterline = waterline_of(hull, {0, radians(pitch), radians(roll)});
                const auto [low, high] = std::minmax_element(waterline.begin(), waterline.end(),
                                                             [](Vec2d a, Vec2d b) { return a.x < b.x; });
                ASSERT_FALSE(waterline.empty());
                if (pitch == 0) {
                    EXPECT_GT(high->x - low->x, ship.length_m);
                }
                for (const std::vector<Vec3d>& wall : walls) {
                    const Vec3d out = glm::normalize(glm::cross(wall[1] - wall[0], wall[2] - wall[0]));
                    for (const Vec2d& point : waterline)
                        EXPECT_LT(glm::dot(out, Vec3d(point, 0.0) - wall[0]), -0.25)
                            << name << " at pitch " << pitch << ", roll " << roll;
                }
            }
    }
}

TEST(Ships, TheBoxReachesBelowTheKeelAtEveryAllowedAttitude) {
    for (const Ship& ship : ships()) {
        const std::string name = ship.name;
        const auto hull = faces_of(two_ships(), ship.hull);
        for (const char* box : {" plain box", " fitted box"}) {
            double least = 0; // of the depths at the ends, where a pitched hull reaches deepest
            double end = 0;
            for (const std::vector<Vec3d>& wall : faces_of(two_ships(), {name + box}))
                for (const Vec3d& corner : wall)
                    if (std::fabs(corner.x) >= std::fabs(end)) {
                        end = corner.x;
                        least = std::min(least, corner.z);
                    }
            for (const double pitch : {-10.0, 10.0})
                for (const double roll : {-8.0, 8.0}) {
                    const Mat3d turn = world_from_body({0, radians(pitch), radians(roll)});
                    for (const std::vector<Vec3d>& face : hull)
                        for (const Vec3d& corner : face)
                            EXPECT_GT((turn * corner).z, least) << name << box;
                }
        }
    }
}

TEST(Ships, WedgesReachTheWaterAndNoFurtherThanTheirStep) {
    for (const Ship& ship : ships())
        for (const auto& [end, sign] : {std::pair{"bow", 1.0}, std::pair{"stern", -1.0}})
            for (int k = 1; k <= 20; ++k) {
                const std::string name = std::string(ship.name) + " wedge " + end + "." + std::to_string(k);
                const auto faces = faces_of(two_ships(), {name});
                ASSERT_GT(faces.size(), 4U) << name;
                const SineCosine up = sine_cosine(radians(0.5 * k));
                double furthest = 0;
                for (const std::vector<Vec3d>& face : faces)
                    for (const Vec3d& corner : face) {
                        if (corner.z == 0) continue;
                        EXPECT_GT(sign * corner.x, 0) << name;
                        const double water = -sign * corner.x * up.sine / up.cosine;
                        EXPECT_LT(corner.z, water + 1e-3) << name << ": a gap above the water";
                        EXPECT_GT(corner.z, water - 0.08) << name;
                        furthest = std::max(furthest, sign * corner.x);
                    }
                EXPECT_GT(furthest, 75) << name << " reaches to the end";
            }
}

} // namespace
} // namespace linkdig::database
