#include "database/compiler/polygon.h"

#include "database/model/random.h"

#include <gtest/gtest.h>

#include <vector>

namespace linkdig::database {
namespace {

TEST(Polygon, CoordinatesAreThoseOfFloats) {
    // In a row of three: an optimiser that takes components in pairs must not keep the digits.
    std::vector<Vec3d> points;
    for (std::uint64_t i = 0; i < 100; ++i)
        points.emplace_back(random_unit(1, 3 * i), random_unit(1, 3 * i + 1), random_unit(1, 3 * i + 2));
    for (const Vec3d& point : points) {
        const Vec4d stored = as_float(point);
        for (int axis = 0; axis < 3; ++axis) {
            volatile float expected = static_cast<float>(point[axis]);
            EXPECT_EQ(stored[axis], static_cast<double>(expected));
        }
        EXPECT_EQ(stored.w, 1.0);
    }
}

std::vector<Vec4d> polygon(std::initializer_list<Vec3d> points) {
    std::vector<Vec4d> corners;
    for (const Vec3d& point : points)
        corners.emplace_back(point, 1.0);
    return corners;
}

TEST(Polygon, ItsPlaneFacesWhereItsCornersRunCounterClockwise) {
    const PolygonReport report = examine(polygon({{5, 0, 2}, {5, 1, 2}, {5, 1, 4}, {5, 0, 4}}));
    EXPECT_EQ(report.fault, PolygonFault::none);
    EXPECT_EQ(report.plane.normal, Vec3d(1, 0, 0));
    EXPECT_DOUBLE_EQ(report.plane.distance, 5);
    EXPECT_DOUBLE_EQ(report.allowed_m, plane_tolerance_m);
}

TEST(Polygon, FarFromTheOriginItIsTheSame) {
    const Vec3d far(4e6, -3e6, 2e6);
    EXPECT_EQ(examine(polygon({far, far + Vec3d(4, 0, 0), far + Vec3d(4, 4, 0), far + Vec3d(0, 4, 0)})).fault,
              PolygonFault::none);
    EXPECT_EQ(
        examine(polygon({far, far + Vec3d(4, 0, 0), far + Vec3d(4, 4, 0.1), far + Vec3d(0, 4, 0)})).fault,
        PolygonFault::not_planar);
}

TEST(Polygon, CornersInARowAreAllowedAndSpikesAreNot) {
    EXPECT_EQ(examine(polygon({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}})).fault,
              PolygonFault::none);
    EXPECT_NE(examine(polygon({{0, 0, 0}, {3, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}})).fault,
              PolygonFault::none);
}

TEST(Polygon, AShearedBowTieIntersectsItself) {
    EXPECT_EQ(examine(polygon({{0, 0, 0}, {4, 4, 0}, {4, 0, 0}, {0, 4, 0}})).fault,
              PolygonFault::self_intersecting);
    EXPECT_EQ(examine(polygon({{0, 0, 0}, {4, 4, 0}, {4, 0, 0}, {0, 2, 0}})).fault,
              PolygonFault::self_intersecting);
}

TEST(Polygon, NeighboursDoNotOverlap) {
    const Vec3d up(0, 0, 1);
    const auto square = [](double x) {
        return polygon({{x, 0, 0}, {x + 2, 0, 0}, {x + 2, 2, 0}, {x, 2, 0}});
    };
    EXPECT_TRUE(overlap_in_plane(square(0), square(1), up));
    EXPECT_TRUE(overlap_in_plane(square(0), square(1.99), up));
    EXPECT_FALSE(overlap_in_plane(square(0), square(1.9995), up)) << "within a millimetre";
    EXPECT_FALSE(overlap_in_plane(square(0), square(2), up));
    EXPECT_TRUE(overlap_in_plane(square(0), polygon({{0.5, 0.5, 0}, {1, 0.5, 0}, {1, 1, 0}}), -up));
}

} // namespace
} // namespace linkdig::database
