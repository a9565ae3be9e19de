// Wave particles: what they carry, how they spread and come back, and that their sum repeats.

#include "database/model/mathematics.h"
#include "database/model/random.h"
#include "ig/water/wave_particles.h"
#include "tests/support/wave_normal.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace linkdig::ig {
namespace {

const WaveParticleKind kind{.speed_mps = 5.0, .radius = 4.0, .least_amplitude = 1e-6, .lifetime_s = 1e9};

double total(const WaveParticles& water) {
    double sum = 0.0;
    for (const WaveParticle& particle : water.particles())
        sum += particle.amplitude;
    return sum;
}

WaveParticles seeded(std::uint32_t number) {
    WaveParticles water(kind);
    WaveParticleCount count;
    for (std::uint32_t k = 0; k < number; ++k)
        water.add({.source = {400.0 * random_unit(1, k) - 200.0, 400.0 * random_unit(2, k) - 200.0},
                   .direction = {random_unit(3, k) - 0.5, random_unit(4, k) - 0.5},
                   .amplitude = random_unit(5, k) - 0.5},
                  count);
    return water;
}

TEST(WaveParticles, SumToTheWaterThatTheyCarry) {
    WaveParticles water(kind);
    WaveParticleCount count;
    water.add({.source = {3.3, -7.1}, .amplitude = 2.0}, count);
    const SurfaceGrid grid{.size = 256, .cell = 0.25, .centre = {0, 0}};
    const database::WaveField field = water.surface(grid);
    double volume = 0.0;
    for (const float h : field.heights)
        volume += static_cast<double>(h) * grid.cell * grid.cell;
    EXPECT_NEAR(volume, 2.0 * water.water_of_unit(), 0.01 * volume);
    EXPECT_NEAR(static_cast<double>(std::ranges::max(field.heights)), 2.0, 0.02);
}

TEST(WaveParticles, KindsAndGridsWithoutExtentAreRefused) {
    for (const WaveParticleKind& bad :
         {WaveParticleKind{.speed_mps = 0.0}, WaveParticleKind{.radius = -1.0},
          WaveParticleKind{.lifetime_s = std::numeric_limits<double>::quiet_NaN()}})
        EXPECT_THROW(WaveParticles{bad}, std::invalid_argument);
    WaveParticles water(kind);
    for (const double cell : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()})
        EXPECT_THROW(water.surface({.size = 8, .cell = cell}), std::invalid_argument) << cell;
    EXPECT_THROW(water.surface({.size = 0, .cell = 1.0}), std::invalid_argument);
}

TEST(WaveParticles, NormalsAreThoseOfTheBump) {
    // h = (1 + cos(pi d / r)) / 2 has the slope -pi / (2 r) sin(pi d / r) away from its middle.
    constexpr double radius = 40.0; // cells: differences between neighbours are then as good as the slope
    WaveParticles water({.speed_mps = 5.0, .radius = radius, .least_amplitude = 1e-6});
    WaveParticleCount count;
    water.add({.source = {0.5, 0.5}, .amplitude = 8.0}, count);
    const database::WaveField field = water.surface({.size = 128, .cell = 1.0, .centre = {0, 0}});
    double inside = 0.0;
    double at_rim = 0.0;
    for (std::uint32_t row = 1; row < 127; ++row)
        for (std::uint32_t column = 1; column < 127; ++column) {
            const Vec2d off = field.origin + Vec2d(column, row) + Vec2d(0.5) - Vec2d(0.5);
            const double d = glm::length(off);
            const double steep =
                d < radius && d > 0.0 ? -8.0 * pi / (2.0 * radius) * sine(pi * d / radius) / d : 0.0;
            const Vec3d wanted = glm::normalize(Vec3d(-steep * off.x, -steep * off.y, 1.0));
            const Vec3d made(support::normal_at(field, column, row));
            EXPECT_NEAR(glm::length(made), 1.0, 1e-6);
            double& greatest = std::fabs(d - radius) < 1.0 ? at_rim : inside;
            greatest = std::max(greatest, glm::length(made - wanted));
        }
    // 0.2 % of the steepest slope, 8 pi / 80. Across the rim, where curvature begins at once, a difference is off by a quarter of it.
    EXPECT_LT(inside, 0.002 * 8.0 * pi / 80.0);
    EXPECT_LT(at_rim, 1.01 * 0.25 * 4.0 * (pi / radius) * (pi / radius));
}

TEST(WaveParticles, HaveTheRaisedCosineForABump) {
    WaveParticles water(kind);
    WaveParticleCount count;
    water.add({.source = {0.5, 0.5}, .amplitude = 1.0}, count);
    const SurfaceGrid grid{.size = 64, .cell = 1.0, .centre = {0, 0}};
    const database::WaveField field = water.surface(grid);
    for (int right = -6; right <= 6; ++right) {
        const double d = std::min(std::abs(right) / kind.radius, 1.0);
        EXPECT_NEAR(static_cast<double>(field.heights[32 * 64 + static_cast<std::size_t>(32 + right)]),
                    0.5 * (1.0 + cosine(pi * d)), 1e-3)
            << right;
    }
}

TEST(WaveParticles, KeepTheirSumWhenTheySpread) {
    WaveParticles water(kind);
    WaveParticleCount count;
    water.add({.source = {10, 20}, .direction = {0, 1}, .amplitude = 3.0, .dispersion_rad = two_pi}, count);
    for (int frame = 0; frame < 240; ++frame)
        water.advance(1.0 / 60.0, {}, count);
    EXPECT_NEAR(total(water), 3.0, 1e-6);
    EXPECT_GT(water.particles().size(), 30U);
    for (const WaveParticle& particle : water.particles()) {
        EXPECT_NEAR(glm::length(particle.position() - Vec2d(10, 20)), 20.0, 1e-9); // 4 s at 5 m/s
        EXPECT_LE(particle.dispersion_rad * particle.travelled, 0.5 * kind.radius);
    }
}

TEST(WaveParticles, AreRemovedWhenTooLowAndWhenOld) {
    WaveParticleKind short_lived = kind;
    short_lived.least_amplitude = 0.1;
    short_lived.lifetime_s = 1.0;
    WaveParticles water(short_lived);
    WaveParticleCount count;
    EXPECT_FALSE(water.add({.amplitude = 0.05}, count));
    EXPECT_TRUE(water.add({.amplitude = 1.0}, count));
    for (int frame = 0; frame < 2 * 60; ++frame)
        water.advance(1.0 / 60.0, {}, count);
    EXPECT_EQ(water.particles().size(), 1U); // e^-2
    for (int frame = 0; frame < 30; ++frame)
        water.advance(1.0 / 60.0, {}, count);
    EXPECT_EQ(water.particles().size(), 0U); // e^-2.5 is below 0.1
    EXPECT_EQ(count.removed, 1U);
}

TEST(WaveParticles, ComeBackFromAQuayAsFromItsMirrorImage) {
    WaveParticles water(kind);
    WaveParticleCount count;
    const std::vector<Quay> quays{{{30, -1000}, {30, 1000}}};
    water.add({.source = {0, 0}, .direction = {1, 0}, .amplitude = 1.0, .dispersion_rad = two_pi}, count);
    for (int frame = 0; frame < 600; ++frame)
        water.advance(1.0 / 60.0, quays, count);
    EXPECT_GT(count.reflected, 0U);
    EXPECT_NEAR(total(water), 1.0, 1e-6);
    for (const WaveParticle& particle : water.particles()) {
        EXPECT_LE(particle.position().x, 30.0 + 1e-9);
        const double direct = glm::length(particle.position());
        const double back = glm::length(particle.position() - Vec2d(60, 0));
        EXPECT_LT(std::min(std::fabs(direct - 50.0), std::fabs(back - 50.0)), 1e-6); // 10 s at 5 m/s
    }
}

TEST(WaveParticles, StayWithinTheirNumber) {
    WaveParticleKind few = kind;
    few.most = 20;
    WaveParticles water(few);
    WaveParticleCount count;
    for (int k = 0; k < 30; ++k)
        water.add({.amplitude = 1.0, .dispersion_rad = two_pi}, count);
    EXPECT_EQ(count.refused, 10U);
    for (int frame = 0; frame < 120; ++frame)
        water.advance(1.0 / 60.0, {}, count);
    EXPECT_LE(water.particles().size(), 20U);
    EXPECT_NEAR(total(water), 20.0, 1e-6);
}

TEST(WaveParticles, SumToTheSameBytesForAnyThreadsAndOrder) {
    WaveParticles water = seeded(20'000);
    const SurfaceGrid grid{.size = 500, .cell = 0.8, .centre = {3.7, -1.2}};
    const database::WaveField expected = water.surface(grid);
    {
        const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
        EXPECT_EQ(water.surface(grid).heights, expected.heights);
    }
    WaveParticles reversed(kind);
    WaveParticleCount count;
    for (std::size_t k = water.particles().size(); k > 0; --k)
        reversed.add(water.particles()[k - 1], count);
    EXPECT_EQ(reversed.surface(grid).heights, expected.heights);
}

TEST(WaveParticles, LieStillOnAGridThatMoves) {
    WaveParticles water = seeded(500);
    const database::WaveField here = water.surface({.size = 256, .cell = 2.0, .centre = {0, 0}});
    const database::WaveField there = water.surface({.size = 256, .cell = 2.0, .centre = {6.3, 0.4}});
    EXPECT_EQ(there.origin, here.origin + Vec2d(6, 0));
    for (std::size_t row = 0; row < 256; ++row)
        for (std::size_t column = 0; column + 3 < 256; ++column)
            ASSERT_NEAR(here.heights[row * 256 + column + 3], there.heights[row * 256 + column], 1e-3F);
}

TEST(WaveParticles, OfAHullUnderWayRunAheadHighAndAsternLow) {
    Silhouette silhouette = empty_silhouette(16, 2.0, Vec2d(-16.0));
    for (std::uint32_t row = 6; row < 10; ++row)
        for (std::uint32_t column = 3; column < 13; ++column)
            silhouette.filled[silhouette.at(column, row)] = 1;
    for (std::uint32_t row = 6; row < 10; ++row) {
        silhouette.indirect[silhouette.at(12, row)] = 10.0;
        silhouette.indirect[silhouette.at(3, row)] = -10.0;
    }
    WaveParticles water(kind);
    WaveParticleCount count;
    water.add(silhouette, boundary_waves(silhouette), 0.5, count);
    EXPECT_GT(count.born, 8U);
    EXPECT_NEAR(total(water), 0.0, 1e-9); // as much room astern as water ahead
    double ahead = 0.0;
    for (const WaveParticle& particle : water.particles())
        if (particle.position().x > 0.0) ahead += particle.amplitude * water.water_of_unit();
    EXPECT_NEAR(ahead, 20.0,
                3.0); // 40 m^3/s for half a second; a little goes along the sides to the other half
}

} // namespace
} // namespace linkdig::ig
