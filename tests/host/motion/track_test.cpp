#include "host/motion/helicopter.h"
#include "host/motion/ship.h"

#include <gtest/gtest.h>

#include <cmath>

namespace linkdig::host {
namespace {

ShipTrack track_of(ShipTrack::Kind kind, double angle_rad = 0.0) {
    return {.start_m = {10, -20, 0},
            .heading_rad = radians(30.0),
            .speed_mps = 6.0,
            .kind = kind,
            .begin_s = 50.0,
            .radius_m = 400.0,
            .to_port = true,
            .angle_rad = angle_rad};
}

double distance_to(const Steering& a, const Steering& b) { return glm::distance(a.position_m, b.position_m); }

/// A ship goes along her heading, at her speed, without a jump: whatever the track.
void expect_sails(const ShipTrack& track, double until_s) {
    const double step = 0.01;
    for (double time = 0.0; time < until_s; time += 1.37) {
        const Steering now = track.at(time);
        const Vec3d way = track.at(time + step).position_m - now.position_m;
        ASSERT_NEAR(glm::length(way), track.speed_mps * step, 1e-6) << time;
        ASSERT_NEAR(glm::dot(glm::normalize(way), direction(now.heading_rad, 0.0)), 1.0, 1e-6) << time;
        ASSERT_EQ(now.position_m.z, 0.0);
    }
}

TEST(ShipTrack, SailsAlongHerHeading) {
    expect_sails(track_of(ShipTrack::Kind::straight), 1000.0);
    expect_sails(track_of(ShipTrack::Kind::turn), 1000.0);
    expect_sails(track_of(ShipTrack::Kind::turn, radians(110.0)), 1000.0);
    expect_sails(track_of(ShipTrack::Kind::figure_of_eight), 2000.0);
}

TEST(ShipTrack, TurnsThroughItsAngle) {
    const ShipTrack track = track_of(ShipTrack::Kind::turn, radians(90.0));
    const Steering after = track.at(50.0 + 400.0 * pi / 2.0 / 6.0);
    EXPECT_NEAR(degrees(after.heading_rad), 120.0, 1e-9);
    const Steering helm_over = track.at(50.0);
    EXPECT_NEAR(distance_to(after, helm_over), 400.0 * std::sqrt(2.0), 1e-6);
    EXPECT_NEAR(degrees(track.at(5000.0).heading_rad), 120.0, 1e-9);
}

TEST(ShipTrack, TheFigureOfEightComesBackAndGoesToBothSides) {
    const ShipTrack track = track_of(ShipTrack::Kind::figure_of_eight);
    const double circle_s = two_pi * 400.0 / 6.0;
    const Steering helm_over = track.at(50.0);
    EXPECT_NEAR(distance_to(track.at(50.0 + circle_s), helm_over), 0.0, 1e-6);
    EXPECT_NEAR(distance_to(track.at(50.0 + 2.0 * circle_s), helm_over), 0.0, 1e-6);
    const auto abeam = [&](double time) {
        return (glm::transpose(helm_over.world_from_mean()) *
                (track.at(time).position_m - helm_over.position_m))
            .y;
    };
    EXPECT_NEAR(abeam(50.0 + circle_s / 2.0), 800.0, 1e-6) << "to port first";
    EXPECT_NEAR(abeam(50.0 + circle_s * 1.5), -800.0, 1e-6);
}

TEST(ShipTrack, AStationStaysWhereItIsInTheLeadersFrame) {
    const ShipTrack leader = track_of(ShipTrack::Kind::turn);
    ShipTrack follower = leader;
    follower.station_m = {-300.0, 60.0, 0.0};
    for (const double time : {0.0, 49.0, 100.0, 333.0}) {
        const Steering of = leader.at(time);
        const Vec3d seen =
            glm::transpose(of.world_from_mean()) * (follower.at(time).position_m - of.position_m);
        EXPECT_NEAR(glm::distance(seen, follower.station_m), 0.0, 1e-9);
        EXPECT_EQ(follower.at(time).heading_rad, of.heading_rad);
    }
}

/// On a straight course the two forms of the motion are the same, whatever the course.
TEST(CurvedMotion, IsTheStraightOneOnAStraightCourse) {
    const Seaway seaway{
        .significant_height_m = 2.5, .modal_period_s = 9.0, .travel_heading_rad = 2.0, .seed = 5};
    ShipTrack track = track_of(ShipTrack::Kind::straight);
    track.start_m = {};
    const ShipResponse response = large_ship_response();
    const ShipMotion straight(seaway, response, track.heading_rad, track.speed_mps);
    const CurvedMotion curved(seaway, response, track.speed_mps);
    double largest = 0.0;
    for (double time = 0.0; time < 500.0; time += 3.3) {
        const ShipMotionValues a = straight.at(time);
        const ShipMotionValues b = curved.at(time, track.at(time));
        for (std::size_t axis = 0; axis < ship_axes; ++axis) {
            EXPECT_NEAR(a[axis], b[axis], 1e-9) << time << " " << axis;
            largest = std::max(largest, std::fabs(a[axis]));
        }
    }
    EXPECT_GT(largest, 0.1) << "she moved";
}

TEST(CurvedMotion, KeepsItsLimitsInATurn) {
    const Seaway seaway{
        .significant_height_m = 9.0, .modal_period_s = 9.0, .travel_heading_rad = 2.0, .seed = 5};
    const ShipTrack track = track_of(ShipTrack::Kind::turn);
    const CurvedMotion motion(seaway, large_ship_response(), track.speed_mps);
    for (double time = 0.0; time < 600.0; time += 0.5) {
        const ShipMotionValues values = motion.at(time, track.at(time));
        EXPECT_LE(std::fabs(values[3]), radians(8.0) + 1e-12);
        EXPECT_LE(std::fabs(values[4]), radians(5.0) + 1e-12);
    }
}

TEST(MotionHistory, IsLinearBetweenItsRowsAndStandsStillBeyond) {
    const MotionHistory history{.time_s = {1.0, 3.0}, .values = {{0, 0, 0, 0, 1.0, 0}, {0, 0, 0, 0, 2.0, 0}}};
    EXPECT_EQ(history.at(0.0)[4], 1.0);
    EXPECT_EQ(history.at(1.0)[4], 1.0);
    EXPECT_EQ(history.at(2.5)[4], 1.75);
    EXPECT_EQ(history.at(99.0)[4], 2.0);
    EXPECT_EQ(MotionHistory{}.at(1.0)[4], 0.0);
}

HelicopterState flown_for(double seconds, const HelicopterControls& controls, HelicopterState state = {}) {
    for (int i = 0; i < static_cast<int>(seconds * 60.0); ++i)
        state = flown(state, controls, 1.0 / 60.0);
    return state;
}

TEST(Helicopter, HangsStillWithoutControls) {
    const HelicopterState start{.position_m = {0, 0, 50}, .velocity_mps = {}, .attitude = {}};
    EXPECT_EQ(flown_for(10.0, {}, start), start);
}

TEST(Helicopter, GoesWhereTheControlsPoint) {
    const HelicopterState start{.position_m = {0, 0, 50}, .velocity_mps = {}, .attitude = {}};
    const HelicopterState ahead = flown_for(5.0, {.stick_fore = 1.0}, start);
    EXPECT_GT(ahead.velocity_mps.x, 5.0);
    EXPECT_LT(ahead.attitude.pitch_rad, 0.0) << "nose down";
    EXPECT_NEAR(ahead.velocity_mps.y, 0.0, 1e-9);
    EXPECT_LT(flown_for(5.0, {.stick_right = 1.0}, start).velocity_mps.y, -5.0) << "y is to port";
    EXPECT_NEAR(flown_for(2.0, {.pedals_right = 1.0}, start).attitude.heading_rad, two_pi - radians(60.0),
                1e-9);
    EXPECT_GT(flown_for(5.0, {.collective = 1.0}, start).position_m.z, 70.0);
}

/// Drag balances g tan(tilt): the end speed of the equation of motion.
TEST(Helicopter, ReachesTheSpeedAtWhichDragBalancesTheTilt) {
    const HelicopterState fast =
        flown_for(120.0, {.stick_fore = 1.0}, {.position_m = {0, 0, 50}, .velocity_mps = {}, .attitude = {}});
    EXPECT_NEAR(fast.velocity_mps.x, 9.80665 * std::tan(greatest_tilt_rad) / drag_per_s, 0.1);
}

TEST(Helicopter, DoesNotFlyIntoTheSea) {
    const HelicopterState low =
        flown_for(60.0, {.collective = -1.0}, {.position_m = {0, 0, 50}, .velocity_mps = {}, .attitude = {}});
    EXPECT_EQ(low.position_m.z, least_height_m);
}

} // namespace
} // namespace linkdig::host
