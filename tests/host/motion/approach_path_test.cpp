#include "host/motion/approach_path.h"
#include "host/motion/view.h"

#include <gtest/gtest.h>

#include <cmath>

namespace linkdig::host {
namespace {

const ApproachPath path{
    .control_m = {Vec3d(-490, -110, 60), Vec3d(-330, -40, 56), Vec3d(-190, 95, 33), Vec3d(-42, 45, 28)},
    .first_aim_m = Vec3d(0, 0, 18),
    .last_aim_m = Vec3d(14, -6, 19),
    .duration_s = 20.0};

TEST(Easing, StartsEndsAndNeverTurnsBack) {
    EXPECT_EQ(easing(-1.0), 0.0);
    EXPECT_EQ(easing(0.0), 0.0);
    EXPECT_NEAR(easing(1.0), 1.0, 1e-15);
    EXPECT_NEAR(easing(7.0), 1.0, 1e-15);
    double last_speed = 1e9;
    for (int i = 0; i < 1000; ++i) {
        const double speed = (easing((i + 1) / 1000.0) - easing(i / 1000.0)) * 1000.0;
        EXPECT_GE(speed, 0.0) << i;
        EXPECT_LE(speed, last_speed + 1e-9) << "a pilot slows down, " << i;
        last_speed = speed;
    }
    EXPECT_LT(last_speed, 1e-4);
}

TEST(ApproachPath, StartsAndEndsWhereSaid) {
    EXPECT_EQ(path.at(0.0).eye_m, path.control_m[0]);
    EXPECT_EQ(path.at(-3.0).eye_m, path.control_m[0]);
    EXPECT_EQ(path.at(0.0).aim_m, path.first_aim_m);
    for (const double time : {20.0, 20.5, 1e6}) {
        EXPECT_LT(glm::distance(path.at(time).eye_m, path.control_m[3]), 1e-9);
        EXPECT_LT(glm::distance(path.at(time).aim_m, path.last_aim_m), 1e-9);
    }
}

/// Central differences over the whole flight and past the hover: neither speed nor acceleration jumps.
TEST(ApproachPath, IsSmoothIntoTheHover) {
    const double step = 0.01;
    const auto speed = [&](double t) {
        return (path.at(t + step).eye_m - path.at(t - step).eye_m) / (2 * step);
    };
    const auto sight = [&](double t) {
        const EyeAndAim at = path.at(t);
        return looking_along(at.aim_m - at.eye_m);
    };
    Vec3d last_acceleration = (speed(0.1 + step) - speed(0.1 - step)) / (2 * step);
    double last_turn = (sight(0.1 + step).heading_rad - sight(0.1 - step).heading_rad) / (2 * step);
    for (double t = 0.1; t < 25.0; t += step) {
        const Vec3d acceleration = (speed(t + step) - speed(t - step)) / (2 * step);
        EXPECT_LT(glm::length(speed(t + step) - speed(t)), 6.0 * step) << t;
        EXPECT_LT(glm::length(acceleration - last_acceleration), 3.0 * step) << t;
        last_acceleration = acceleration;
        const double turn = (sight(t + step).heading_rad - sight(t - step).heading_rad) / (2 * step);
        EXPECT_LT(std::fabs(turn - last_turn), 0.1 * step) << "line of sight, " << t;
        last_turn = turn;
    }
    EXPECT_LT(glm::length(speed(20.1)), 1e-9);
}

TEST(LookingAlong, GivesTheLineOfSightBack) {
    for (const Vec3d& sight : {Vec3d(1, 0, 0), Vec3d(-3, 2, -1), Vec3d(0, -5, 0.1), Vec3d(0, 0, -2)}) {
        const Mat3d axes = world_from_body(looking_along(sight));
        EXPECT_LT(glm::distance(axes[0], glm::normalize(sight)), 1e-11);
        EXPECT_NEAR(axes[1].z, 0.0, 1e-12) << "the horizon is level";
    }
}

TEST(AttitudeOf, GivesRotationsBack) {
    for (double heading = -3.0; heading < 3.1; heading += 0.7)
        for (const double pitch : {-1.5707963267948966, -1.2, 0.0, 0.4, 1.5707963267948966})
            for (const double roll : {-2.0, 0.0, 0.3}) {
                const Mat3d given = world_from_body({heading, pitch, roll});
                const Mat3d found = world_from_body(attitude_of(given));
                for (int column = 0; column < 3; ++column)
                    EXPECT_LT(glm::distance(given[column], found[column]), 1e-10)
                        << heading << " " << pitch << " " << roll;
            }
}

TEST(Mounted, TurnsAboutTheCarriersAxes) {
    const Attitude carrier{.heading_rad = 0.4, .pitch_rad = -0.2};
    const Attitude left = mounted(carrier, {.heading_rad = 1.5707963267948966});
    EXPECT_LT(glm::distance(world_from_body(left)[0], world_from_body(carrier)[1]), 1e-11);
    EXPECT_NEAR(left.pitch_rad, 0.0, 1e-11);
    const Attitude down = mounted(carrier, {.pitch_rad = -0.8});
    EXPECT_NEAR(down.pitch_rad, -1.0, 1e-11);
    EXPECT_NEAR(down.heading_rad, 0.4, 1e-11);
}

} // namespace
} // namespace linkdig::host
