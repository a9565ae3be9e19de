#include "host/motion/sun.h"

#include "database/model/mathematics.h"

#include <gtest/gtest.h>

#include <cmath>

namespace linkdig::host {
namespace {

TEST(OceanSun, StandsStillWithoutIncrements) {
    const OceanSun sun{.initial = {1.25, 0.5}};
    for (const std::uint64_t frame : {0ULL, 1ULL, 1000000ULL}) {
        EXPECT_EQ(sun.position(frame).azimuth_rad, 1.25);
        EXPECT_NEAR(sun.position(frame).elevation_rad, 0.5, 1e-15);
    }
}

/// Figure 7 as drawn: w = w + dw, theta = theta + dtheta, frame by frame.
TEST(OceanSun, AdvancesByItsTwoIncrementsEachFrame) {
    const OceanSun sun{.initial = {0.3, 0.2},
                       .azimuth_increment_rad = 0.0419,
                       .elevation_increment_rad = 0.001,
                       .greatest_elevation_rad = 1.4};
    double azimuth = 0.3;
    double elevation = 0.2;
    for (std::uint64_t frame = 0; frame < 1000; ++frame) {
        const SunPosition position = sun.position(frame);
        EXPECT_NEAR(position.azimuth_rad, std::fmod(azimuth, two_pi), 1e-11) << frame;
        EXPECT_NEAR(position.elevation_rad, elevation, 1e-12) << frame;
        azimuth += 0.0419;
        elevation += 0.001;
    }
}

/// A turn of exactly 150 frames: every 150th frame is the first again, to a rounding, whatever came between.
TEST(OceanSun, DoesNotDriftInTwentyMinutesNorInADay) {
    const OceanSun sun{.initial = {1.0, 0.5}, .azimuth_increment_rad = two_pi / 150.0};
    for (std::uint64_t frame = 0; frame <= 36000; frame += 150)
        EXPECT_NEAR(sun.position(frame).azimuth_rad, 1.0, 1e-12) << frame;
    EXPECT_NEAR(sun.position(150ULL * 34560).azimuth_rad, 1.0, 1e-10);
    for (std::uint64_t frame = 0; frame < 36000; ++frame) {
        const double exact = std::fmod(1.0 + static_cast<double>(frame % 150) * two_pi / 150.0, two_pi);
        const double found = sun.position(frame).azimuth_rad;
        ASSERT_GE(found, 0.0);
        ASSERT_LT(found, two_pi);
        ASSERT_NEAR(std::cos(found - exact), 1.0, 1e-12) << frame;
    }
}

TEST(OceanSun, TurnsBackwardsToo) {
    const OceanSun sun{.initial = {0.1, 0.5}, .azimuth_increment_rad = -0.25};
    EXPECT_NEAR(sun.position(1).azimuth_rad, two_pi - 0.15, 1e-12);
    EXPECT_NEAR(sun.position(1, 2.0).azimuth_rad, two_pi - 0.4, 1e-12);
    EXPECT_NEAR(sun.position(1000, 0.0).azimuth_rad, 0.1, 1e-12);
}

TEST(OceanSun, ElevationIsReflectedBetweenItsLimits) {
    const OceanSun sun{.initial = {0.0, 0.5},
                       .elevation_increment_rad = 0.013,
                       .least_elevation_rad = 0.25,
                       .greatest_elevation_rad = 0.75};
    double elevation = 0.5;
    double step = 0.013;
    for (std::uint64_t frame = 0; frame < 2000; ++frame) {
        EXPECT_NEAR(sun.position(frame).elevation_rad, elevation, 1e-10) << frame;
        elevation += step;
        if (elevation > 0.75 || elevation < 0.25) {
            elevation = elevation > 0.75 ? 1.5 - elevation : 0.5 - elevation;
            step = -step;
        }
    }
}

TEST(Reflected, TouchesItsLimits) {
    EXPECT_DOUBLE_EQ(reflected(2.0, 1.0, 2.0), 2.0);
    EXPECT_DOUBLE_EQ(reflected(3.0, 1.0, 2.0), 1.0);
    EXPECT_DOUBLE_EQ(reflected(2.25, 1.0, 2.0), 1.75);
    EXPECT_DOUBLE_EQ(reflected(0.75, 1.0, 2.0), 1.25);
    EXPECT_EQ(reflected(17.0, 1.0, 1.0), 1.0) << "no room between the limits";
}

TEST(SunVector, PointsWhereItStands) {
    const Vec3f up = sun_vector({0.7, pi / 2.0});
    EXPECT_NEAR(up.z, 1.0F, 1e-7F);
    EXPECT_NEAR(up.x, 0.0F, 1e-7F);
    const Vec3f north = sun_vector({pi / 2.0, 0.0});
    EXPECT_NEAR(north.y, 1.0F, 1e-7F);
    const Vec3f any = sun_vector({2.0, 0.6});
    EXPECT_NEAR(any.x, std::cos(2.0) * std::cos(0.6), 1e-7);
    EXPECT_NEAR(any.z, std::sin(0.6), 1e-7);
}

} // namespace
} // namespace linkdig::host
