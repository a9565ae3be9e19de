// The silhouette pyramid: what is conserved, which way discs send their waves, hulls afloat and under water.

#include "database/model/mathematics.h"
#include "database/model/random.h"
#include "ig/water/silhouette_pyramid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace linkdig::ig {
namespace {

double sum(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

double size_of(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0,
                           [](double a, double b) { return a + std::fabs(b); });
}

Silhouette disc(std::uint32_t size, double radius, bool submerged = false) {
    Silhouette silhouette = empty_silhouette(size, 1.0, Vec2d(-0.5 * size));
    for (std::uint32_t row = 0; row < size; ++row)
        for (std::uint32_t column = 0; column < size; ++column)
            if (glm::length(silhouette.origin + Vec2d(column + 0.5, row + 0.5)) <= radius) {
                silhouette.filled[silhouette.at(column, row)] = 1;
                silhouette.submerged[silhouette.at(column, row)] = submerged ? 1 : 0;
            }
    return silhouette;
}

/// Mean and greatest angle between boundary directions and away from the middle, degrees.
Vec2d off_radial(const Silhouette& silhouette, const BoundaryWaves& waves, double sign) {
    Vec2d mean_and_most(0.0);
    double count = 0.0;
    for (std::uint32_t row = 0; row < silhouette.size; ++row)
        for (std::uint32_t column = 0; column < silhouette.size; ++column) {
            const std::size_t at = silhouette.at(column, row);
            if (waves.boundary[at] == 0) continue;
            const Vec2d middle = silhouette.origin + silhouette.pixel * Vec2d(column + 0.5, row + 0.5);
            const Vec2d out = sign * glm::normalize(middle);
            const double angle = degrees(arc_cosine(glm::dot(out, waves.direction[at])));
            mean_and_most.x += angle;
            mean_and_most.y = std::max(mean_and_most.y, angle);
            count += 1.0;
        }
    mean_and_most.x /= count;
    return mean_and_most;
}

HullMotion moving(const Vec3d& position, const Vec3d& velocity_mps) {
    return {.position = position, .velocity_mps = velocity_mps};
}

std::vector<HullTriangle> box(const Vec3d& half) {
    std::vector<HullTriangle> hull;
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {-1.0, 1.0}) {
            const int second = (axis + 1) % 3;
            const int third = (axis + 2) % 3;
            const auto corner = [&](double a, double b) {
                Vec3d point(0.0);
                point[axis] = side * half[axis];
                point[second] = a * side * half[second];
                point[third] = b * half[third];
                return point;
            };
            hull.push_back({corner(-1, -1), corner(1, -1), corner(1, 1)});
            hull.push_back({corner(-1, -1), corner(1, 1), corner(-1, 1)});
        }
    return hull;
}

std::vector<HullTriangle> sphere(double radius) {
    std::vector<HullTriangle> hull = box(Vec3d(1.0));
    for (int level = 0; level < 4; ++level) {
        std::vector<HullTriangle> finer;
        for (const HullTriangle& t : hull) {
            const Vec3d ab = 0.5 * (t[0] + t[1]);
            const Vec3d bc = 0.5 * (t[1] + t[2]);
            const Vec3d ca = 0.5 * (t[2] + t[0]);
            finer.insert(finer.end(), {{t[0], ab, ca}, {ab, t[1], bc}, {ca, bc, t[2]}, {ab, bc, ca}});
        }
        hull = std::move(finer);
    }
    for (HullTriangle& t : hull)
        for (Vec3d& corner : t)
            corner = radius * glm::normalize(corner);
    return hull;
}

TEST(SilhouettePyramid, KeepsTheIndirectEffectOfAThousandSilhouettes) {
    for (std::uint64_t seed = 0; seed < 1000; ++seed) {
        Silhouette silhouette = empty_silhouette(4U << (seed % 5), 1.0, Vec2d(0.0));
        const double share = random_unit(seed, 0);
        for (std::size_t at = 0; at < silhouette.filled.size(); ++at) {
            if (random_unit(seed, 3 * at + 1) >= share) continue;
            silhouette.filled[at] = 1;
            silhouette.submerged[at] = random_unit(seed, 3 * at + 2) < 0.3 ? 1 : 0;
            silhouette.indirect[at] = random_unit(seed, 3 * at + 3) - 0.4;
        }
        for (const SilhouetteBoundary kind : {SilhouetteBoundary::inner, SilhouetteBoundary::outer}) {
            const BoundaryWaves waves = boundary_waves(silhouette, kind);
            const double scale = std::max(1.0, size_of(silhouette.indirect));
            EXPECT_NEAR(sum(waves.indirect), sum(silhouette.indirect), 1e-6 * scale) << seed;
            if (std::ranges::find(waves.boundary, 1) == waves.boundary.end()) continue;
            for (std::size_t at = 0; at < waves.indirect.size(); ++at)
                ASSERT_TRUE(waves.boundary[at] != 0 || waves.indirect[at] == 0.0) << seed;
        }
    }
}

TEST(SilhouettePyramid, SendsADiscsWavesOutward) {
    const Silhouette silhouette = disc(32, 10.0);
    for (const SilhouetteBoundary kind : {SilhouetteBoundary::inner, SilhouetteBoundary::outer}) {
        const Vec2d off = off_radial(silhouette, boundary_waves(silhouette, kind), 1.0);
        RecordProperty(kind == SilhouetteBoundary::inner ? "inner" : "outer",
                       std::to_string(off.x) + " mean, " + std::to_string(off.y) + " at most, degrees");
        EXPECT_LE(off.x, 10.0);
        EXPECT_LE(off.y, kind == SilhouetteBoundary::inner ? 20.0 : 21.0); // 17.0 and 20.7
    }
}

TEST(SilhouettePyramid, TurnsTheWavesOfASubmergedDiscInward) {
    const Silhouette silhouette = disc(32, 10.0, true);
    for (const SilhouetteBoundary kind : {SilhouetteBoundary::inner, SilhouetteBoundary::outer})
        EXPECT_LE(off_radial(silhouette, boundary_waves(silhouette, kind), -1.0).y, 21.0);
}

TEST(SilhouettePyramid, GivesADiscsPixelsTheAngleToTheirNeighbours) {
    const BoundaryWaves waves = boundary_waves(disc(32, 10.0));
    double turn = 0.0;
    for (std::size_t at = 0; at < waves.boundary.size(); ++at) {
        if (waves.boundary[at] == 0) continue;
        EXPECT_LT(waves.dispersion_rad[at], radians(45.0));
        turn += waves.dispersion_rad[at];
    }
    EXPECT_GE(turn, two_pi); // together they leave no gap; directions that wobble make it more
    EXPECT_LE(turn, 3.0 * two_pi);
}

TEST(SilhouettePyramid, LeavesNothingOfAnEmptySilhouette) {
    const BoundaryWaves waves = boundary_waves(empty_silhouette(16, 1.0, Vec2d(0.0)));
    EXPECT_EQ(size_of(waves.indirect) + size_of(waves.direct), 0.0);
    EXPECT_EQ(std::ranges::count(waves.boundary, 1), 0);
    const Silhouette above_water = draw_silhouette(box(Vec3d(5.0)), moving({0, 0, 20}, {0, 0, -1}), 16);
    EXPECT_EQ(std::ranges::count(above_water.filled, 1), 0);
}

TEST(SilhouettePyramid, TakesTheSquaresBorderForTheBoundaryOfAFullSilhouette) {
    Silhouette silhouette = empty_silhouette(8, 1.0, Vec2d(0.0));
    std::ranges::fill(silhouette.filled, 1);
    std::ranges::fill(silhouette.indirect, 1.0);
    const BoundaryWaves inner = boundary_waves(silhouette);
    EXPECT_EQ(std::ranges::count(inner.boundary, 1), 28);
    EXPECT_NEAR(sum(inner.indirect), 64.0, 1e-9);
    const BoundaryWaves outer = boundary_waves(silhouette, SilhouetteBoundary::outer);
    EXPECT_EQ(std::ranges::count(outer.boundary, 1), 0);
    EXPECT_NEAR(sum(outer.indirect), 64.0, 1e-9);
}

TEST(Silhouette, OfABoxUnderWayHasWaterPushedAwayAheadAndRoomAstern) {
    for (const std::uint32_t size : {4U, 8U, 16U, 32U, 64U}) {
        const Silhouette silhouette = draw_silhouette(box({20, 5, 3}), moving({100, 50, 0}, {4, 0, 0}), size);
        double ahead = 0.0;
        double astern = 0.0;
        for (std::size_t at = 0; at < silhouette.indirect.size(); ++at) {
            const double x = silhouette.origin.x + silhouette.pixel * (static_cast<double>(at % size) + 0.5);
            (x > 100.0 ? ahead : astern) += silhouette.indirect[at];
        }
        EXPECT_EQ(size_of(silhouette.direct), 0.0);
        EXPECT_EQ(std::ranges::count(silhouette.submerged, 1), 0);
        EXPECT_NEAR(ahead, 4.0 * 10.0 * 3.0, 1e-9); // speed, beam and draught
        EXPECT_NEAR(astern, -120.0, 1e-9);
        EXPECT_NEAR(sum(boundary_waves(silhouette).indirect), 0.0, 1e-9);
    }
}

TEST(Silhouette, FollowsHeavePitchAndRoll) {
    const auto filled = [](const HullMotion& motion) {
        const Silhouette s = draw_silhouette(box({20, 5, 3}), motion, 64);
        return static_cast<double>(std::ranges::count(s.filled, 1)) * s.pixel * s.pixel;
    };
    EXPECT_NEAR(filled(moving({0, 0, 0}, {})), 400.0, 60.0);
    EXPECT_EQ(filled(moving({0, 0, 4}, {})), 0.0);
    HullMotion pitched = moving({0, 0, 2.5}, {});
    const SineCosine a = sine_cosine(radians(10.0));
    pitched.world_from_body = Mat3d(Vec3d(a.cosine, 0, -a.sine), Vec3d(0, 1, 0), Vec3d(a.sine, 0, a.cosine));
    EXPECT_LT(filled(pitched), 300.0); // one end is out of the water
    EXPECT_GT(filled(pitched), 150.0);
}

TEST(Silhouette, OfASubmergedSphereIsDirectAboveAndIndirectBelow) {
    const double speed = 2.0;
    const Silhouette rising = draw_silhouette(sphere(10.0), moving({0, 0, -15}, {0, 0, speed}), 32);
    EXPECT_EQ(rising.filled, rising.submerged);
    const double swept = speed * pi * 100.0;
    EXPECT_NEAR(sum(rising.direct), swept, 0.03 * swept);
    EXPECT_NEAR(sum(rising.indirect), -swept, 0.03 * swept);
    const BoundaryWaves waves = boundary_waves(rising);
    EXPECT_NEAR(sum(waves.indirect), sum(rising.indirect), 1e-6 * swept);
    const double as_a_disc = off_radial(disc(32, 15.0), boundary_waves(disc(32, 15.0)), 1.0).x;
    EXPECT_LE(off_radial(rising, waves, -1.0).x, as_a_disc + 5.0) << as_a_disc; // inwards
}

} // namespace
} // namespace linkdig::ig
