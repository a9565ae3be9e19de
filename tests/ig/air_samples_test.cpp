// Transmission taken every few elements against that of every pixel.

#include "ig/video/air_samples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <vector>

namespace linkdig::ig {
namespace {

constexpr std::uint32_t side = 1024;
/// Tangents from -0.58 to 0.58: 60 degrees.
constexpr PictureScale scale{256.0 * side / 1.16, 128.0 * side, -256.0 * side / 1.16, 128.0 * side};

Air air_of(double visibility_m) {
    Air air;
    air.prepare(scale, {side, side, Scan::horizontal}, visibility_m, {});
    return air;
}

/// A plane 1/z = `inverse_m` at the picture's first pixel that changes by `along` of that over the picture's width.
DepthPlane plane_of(double inverse_m, double along, double across = 0.0) {
    return {.inverse_m = inverse_m, .across = inverse_m * across / side, .along = inverse_m * along / side};
}

/// The greatest difference from the transmission of the pixel itself over a run, in 1 / 32767.
int greatest_difference(const DepthPlane& depth, const Air& air, const Segment& run,
                        const AirSamples& samples, std::size_t r) {
    int greatest = 0;
    for (std::int32_t k = 0; k < run.count; ++k)
        greatest = std::max(greatest, std::abs(samples.between(samples.of_run[r], k) -
                                               transmission_of(depth, air, run.line, run.first + k)));
    return greatest;
}

TEST(AirSamples, StraightBetweenThemIsAtMostAThirdOfALevelOff) {
    constexpr double third_of_a_level = transmission_one / (3.0 * 255.0);
    const auto samples = std::make_unique<AirSamples>();
    int runs_of_bits[longest_stretch_bits + 1] = {};
    int greatest = 0;
    for (const double visibility_m : {200.0, 1000.0, 5000.0, 40000.0}) {
        const Air air = air_of(visibility_m);
        for (double range_m = 2.0; range_m < 1e5; range_m *= 1.5) {
            for (const double along : {-0.999, -0.9, -0.3, 0.0, 0.5, 1.5, 2.7, 4.0, 6.5, 100.0}) {
                const DepthPlane depth = plane_of(1.0 / range_m, along, 0.1);
                const std::vector<Segment> runs{{0, 0, side}, {500, 3, 20}, {1023, 500, 77}, {7, 900, 124}};
                ASSERT_EQ(samples->plan(runs, depth, air), runs.size());
                samples->work_out();
                for (std::size_t r = 0; r < runs.size(); ++r) {
                    ++runs_of_bits[samples->of_run[r].bits];
                    if (!samples->of_run[r].straight()) continue;
                    greatest = std::max(greatest, greatest_difference(depth, air, runs[r], *samples, r));
                }
            }
        }
    }
    EXPECT_LE(greatest, third_of_a_level + 2); // two roundings
    EXPECT_GE(greatest, third_of_a_level / 3); // the bound is no looser than it must be
    for (const int bits : {0, 4, 5, 6})
        EXPECT_GT(runs_of_bits[bits], 100) << bits;
}

TEST(AirSamples, RunsThatReachTheHorizonOrAreShortAreTakenPixelByPixel) {
    const auto samples = std::make_unique<AirSamples>();
    const Air air = air_of(5000.0);
    const std::vector<Segment> runs{{0, 0, side}, {1, 0, 400}, {2, 0, 16}};
    ASSERT_EQ(samples->plan(runs, plane_of(1.0 / 300.0, -1.01), air), runs.size());
    EXPECT_FALSE(samples->of_run[0].straight());
    EXPECT_TRUE(samples->of_run[1].straight());
    EXPECT_FALSE(samples->of_run[2].straight());
}

TEST(AirSamples, MoreRunsThanThereIsRoomForComeInTurns) {
    const auto samples = std::make_unique<AirSamples>();
    const Air air = air_of(5000.0);
    const DepthPlane depth = plane_of(1.0 / 300.0, 0.1);
    const std::vector<Segment> many(AirSamples::most_runs + 5, Segment{0, 0, 32});
    EXPECT_EQ(samples->plan(many, depth, air), AirSamples::most_runs);
    const std::vector<Segment> wide(AirSamples::most_runs, Segment{0, 0, side});
    const std::size_t planned = samples->plan(wide, depth, air);
    EXPECT_GT(planned, 1U);
    EXPECT_LT(planned, wide.size());
    EXPECT_LE(samples->count, AirSamples::most_samples);
}

} // namespace
} // namespace linkdig::ig
