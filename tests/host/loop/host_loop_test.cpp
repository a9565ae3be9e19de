#include "host/loop/host_loop.h"

#include "host/packet/check_packet.h"
#include "tests/host/loop/first_flight.h"
#include "tests/support/allocation_count.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace linkdig::host {
namespace {

using testing::HasSubstr;

constexpr std::size_t world_row = 0;
constexpr std::size_t ocean_row = 1;
constexpr std::size_t sky_row = 2;
constexpr std::size_t lph2_row = 1;

HostLoop loop_at(double rate_hz, double seconds = 20.0) {
    Scenario scenario = first_flight_scenario();
    scenario.duration_s = seconds;
    return {scenario, first_flight_names(), rate_hz};
}

SignalValues with(Signal signal, double value) {
    SignalValues values;
    values.set(signal, value);
    return values;
}

/// The eye in the ship's waterline frame.
Vec3d beside_ship(const FramePacket& packet) {
    const MovingObject& ship = packet.moving_objects[lph2_row];
    const Mat3d world_from_ship = world_from_body({.heading_rad = ship.waterline_heading_rad});
    return glm::transpose(world_from_ship) * (packet.channels[0].eye_m - ship.waterline_position_m);
}

void expect_same_scene(const FramePacket& a, const FramePacket& b) {
    EXPECT_NEAR(a.time_s, b.time_s, 1e-12);
    for (std::size_t i = 0; i < a.suns.size(); ++i)
        EXPECT_LT(glm::distance(Vec3d(a.suns[i]), Vec3d(b.suns[i])), 1e-9);
    for (std::size_t i = 0; i < a.moving_objects.size(); ++i) {
        const MovingObject& x = a.moving_objects[i];
        const MovingObject& y = b.moving_objects[i];
        EXPECT_LT(glm::distance(x.position_m, y.position_m), 1e-9);
        EXPECT_LT(glm::distance(x.waterline_position_m, y.waterline_position_m), 1e-9);
        EXPECT_NEAR(x.attitude.pitch_rad, y.attitude.pitch_rad, 1e-9);
        EXPECT_NEAR(x.attitude.roll_rad, y.attitude.roll_rad, 1e-9);
        EXPECT_NEAR(x.waterline_heading_rad, y.waterline_heading_rad, 1e-9);
    }
    EXPECT_LT(glm::distance(a.channels[0].eye_m, b.channels[0].eye_m), 1e-9);
    EXPECT_NEAR(a.channels[0].attitude.heading_rad, b.channels[0].attitude.heading_rad, 1e-9);
    EXPECT_NEAR(a.channels[0].attitude.pitch_rad, b.channels[0].attitude.pitch_rad, 1e-9);
    for (std::size_t i = 0; i < a.substitutions.size(); ++i)
        EXPECT_EQ(a.substitutions[i].index, b.substitutions[i].index);
}

TEST(HostLoop, RefusesRatesAndShapesThatAreNone) {
    const Scenario scenario = first_flight_scenario();
    const NameDirectory names = first_flight_names();
    EXPECT_THROW(HostLoop(scenario, names, 0.0), std::invalid_argument);
    EXPECT_THROW(HostLoop(scenario, names, std::numeric_limits<double>::infinity()), std::invalid_argument);
    EXPECT_THROW(HostLoop(scenario, names, 30.0, -1.0), std::invalid_argument);
}

TEST(HostLoop, RefusesADatabaseWithoutItsNames) {
    try {
        const HostLoop loop(first_flight_scenario(), NameDirectory{}, 30.0);
        FAIL() << "an empty directory was accepted";
    } catch (const std::invalid_argument& refused) {
        EXPECT_THAT(refused.what(), HasSubstr("the database has no moving object \"lph2\""));
        EXPECT_THAT(refused.what(), HasSubstr("approach.toml:"));
    }
}

TEST(HostLoop, TablesAreParallelToTheDatabase) {
    HostLoop loop = loop_at(30.0);
    const FramePacket& packet = loop.packet(0, {});
    EXPECT_EQ(packet.suns.size(), 4U);
    EXPECT_EQ(packet.moving_objects.size(), 2U);
    EXPECT_FALSE(packet.moving_objects[0].visible) << "not in the scenario";
    EXPECT_TRUE(packet.moving_objects[lph2_row].visible);
    ASSERT_EQ(packet.substitutions.size(), 2U);
    EXPECT_EQ(packet.substitutions[0].slot, 2U) << "bow_wake_port";
    EXPECT_EQ(packet.substitutions[1].slot, 0U) << "bow_wake_starboard";
    EXPECT_TRUE(packet.lighting.empty());
    EXPECT_EQ(packet.database_id, 0x1234U);
    EXPECT_EQ(packet.seed, 1979U);
    EXPECT_EQ(packet.sea.state, 1.5F);
    EXPECT_EQ(loop.frames(), 600U);
}

TEST(HostLoop, OnlyTheFirstFrameIsADiscontinuity) {
    HostLoop loop = loop_at(30.0);
    EXPECT_TRUE(loop.packet(0, {}).discontinuity);
    EXPECT_FALSE(loop.packet(1, {}).discontinuity);
}

TEST(HostLoop, TheFlightIsTheSameAtThirtyAndSixtyHertz) {
    HostLoop at_30 = loop_at(30.0);
    HostLoop at_60 = loop_at(60.0);
    for (std::uint64_t frame = 0; frame < 700; ++frame) {
        expect_same_scene(at_30.packet(frame, {}), at_60.packet(2 * frame, {}));
        if (HasFailure()) FAIL() << "frame " << frame;
    }
    expect_same_scene(at_30.packet(36000, {}), at_60.packet(72000, {}));
}

/// Frames asked for in any order, or twice, give the same packet.
TEST(HostLoop, APacketIsAPureFunctionOfItsFrame) {
    HostLoop forwards = loop_at(30.0);
    HostLoop anyhow = loop_at(30.0);
    anyhow.packet(500, with(Signal::view, 2));
    anyhow.packet(3, with(Signal::smooth_shading, 0));
    for (const std::uint64_t frame : {17ULL, 2ULL, 2ULL, 599ULL}) {
        const FramePacket expected = forwards.packet(frame, {});
        const FramePacket& found = anyhow.packet(frame, {});
        expect_same_scene(expected, found);
        EXPECT_EQ(expected.suns, found.suns);
        EXPECT_EQ(expected.channels[0].eye_m, found.channels[0].eye_m);
        EXPECT_EQ(expected.lighting.size(), found.lighting.size());
    }
}

TEST(HostLoop, OnlyTheOceansSunTurnsOnceInFiveSeconds) {
    HostLoop loop = loop_at(30.0);
    const FramePacket first = loop.packet(0, {});
    const double elevation = radians(30.0);
    EXPECT_NEAR(first.suns[ocean_row].z, std::sin(elevation), 1e-6);
    EXPECT_NEAR(first.suns[ocean_row].y, std::cos(elevation), 1e-6) << "azimuth 0 is north";
    EXPECT_NEAR(first.suns[sky_row].z, 1.0, 1e-6);
    for (std::uint64_t frame = 1; frame <= 150; ++frame) {
        const FramePacket& packet = loop.packet(frame, {});
        EXPECT_EQ(packet.suns[world_row], first.suns[world_row]);
        EXPECT_EQ(packet.suns[sky_row], first.suns[sky_row]);
        // Clockwise, as the file counts: from north towards east.
        const double compass = two_pi * static_cast<double>(frame) / 150.0;
        EXPECT_NEAR(packet.suns[ocean_row].x, std::cos(elevation) * std::sin(compass), 1e-6) << frame;
        EXPECT_NEAR(packet.suns[ocean_row].y, std::cos(elevation) * std::cos(compass), 1e-6) << frame;
    }
}

TEST(HostLoop, TheShipSteersTwentyDegreesAtTwelveKnots) {
    HostLoop loop = loop_at(30.0);
    const Vec3d start = loop.packet(0, {}).moving_objects[lph2_row].waterline_position_m;
    const Vec3d gone = loop.packet(30 * 600, {}).moving_objects[lph2_row].waterline_position_m - start;
    EXPECT_NEAR(std::hypot(gone.x, gone.y), 2.0 * 1852.0, 4.0) << "ten minutes, give or take surge";
    EXPECT_NEAR(degrees(std::atan2(gone.x, gone.y)), 20.0, 0.1);
}

TEST(HostLoop, TheShipPitchesAndRollsWithinTheLimitsOfALanding) {
    HostLoop loop = loop_at(10.0);
    double pitch = 0.0;
    double roll = 0.0;
    double early_pitch = 0.0;
    double early_roll = 0.0;
    for (std::uint64_t frame = 0; frame < 36000; ++frame) {
        const Attitude& attitude = loop.packet(frame, {}).moving_objects[lph2_row].attitude;
        pitch = std::max(pitch, std::fabs(attitude.pitch_rad));
        roll = std::max(roll, std::fabs(attitude.roll_rad));
        if (frame == 200) {
            early_pitch = pitch;
            early_roll = roll;
        }
    }
    EXPECT_LE(degrees(pitch), 5.0);
    EXPECT_LE(degrees(roll), 8.0);
    EXPECT_GE(degrees(early_pitch), 1.5) << "to be seen in the first 20 s";
    EXPECT_GE(degrees(early_roll), 2.0) << "to be seen in the first 20 s";
}

struct Flight {
    double seconds;
    double astern_m;
};

class Approach : public testing::TestWithParam<Flight> {};

/// From the distance that the length of the flight asks for to a hover abeam, never near the ship's sides.
TEST_P(Approach, StartsAsternEndsAbeamAndKeepsClear) {
    HostLoop loop = loop_at(30.0, GetParam().seconds);
    const Vec3d start = beside_ship(loop.packet(0, {}));
    EXPECT_NEAR(-start.x - 90.2, GetParam().astern_m, 2.0) << "astern of her stern";
    double height = start.z + 1e-6;
    for (std::uint64_t frame = 0; frame <= loop.frames() + 300; ++frame) {
        const FramePacket& packet = loop.packet(frame, {});
        const Vec3d eye = beside_ship(packet);
        const Vec3d outside = glm::max(glm::abs(eye - Vec3d(0, 0, 24)) - Vec3d(92, 26.2, 24), Vec3d(0));
        EXPECT_GT(glm::length(outside), 15.0) << "lifts, island and mast inside the box, frame " << frame;
        EXPECT_LE(packet.channels[0].eye_m.z, height) << "no climbing, frame " << frame;
        EXPECT_GT(packet.channels[0].eye_m.z, 20.0);
        height = packet.channels[0].eye_m.z + 1e-6;
    }
    const Vec3d hover = beside_ship(loop.packet(loop.frames(), {}));
    const Vec3d said = first_flight_scenario().approaches.front().path_m.back();
    EXPECT_LT(glm::distance(hover, said), 4.0) << "surge, sway and yaw move the ship a little";
    EXPECT_NEAR(hover.z, said.z, 1e-9) << "heave does not move the own ship";
    EXPECT_GT(hover.y, 40.0) << "to port, clear of the lift";
    EXPECT_LT(hover.y, 130.0);
    EXPECT_LT(std::fabs(hover.x), 80.0) << "abeam of the flight deck";
}

/// The middle of the ship stays inside the picture's frustum.
TEST_P(Approach, LooksAtTheShip) {
    HostLoop loop = loop_at(30.0, GetParam().seconds);
    for (std::uint64_t frame = 0; frame <= loop.frames(); ++frame) {
        const FramePacket& packet = loop.packet(frame, {});
        const ChannelView& view = packet.channels[0];
        const Vec3d island = packet.moving_objects[lph2_row].waterline_position_m + Vec3d(0, 0, 18);
        const Vec3d seen = glm::transpose(world_from_body(view.attitude)) * (island - view.eye_m);
        ASSERT_GT(seen.x, 0.0) << frame;
        ASSERT_LT(std::fabs(seen.y / seen.x), view.right_tangent * 0.9) << frame;
        ASSERT_LT(std::fabs(seen.z / seen.x), view.top_tangent * 0.9) << frame;
        ASSERT_NEAR(view.attitude.roll_rad, 0.0, 1e-9);
        ASSERT_GT(view.top_tangent + std::tan(view.attitude.pitch_rad), 0.0)
            << "the horizon is in the picture";
    }
}

INSTANTIATE_TEST_SUITE_P(Lengths, Approach, testing::Values(Flight{20.0, 400.0}, Flight{60.0, 926.0}));

TEST(HostLoop, AnApproachWithoutAShipHangsInTheWorld) {
    Scenario scenario = first_flight_scenario();
    for (ApproachSection& each : scenario.approaches)
        each.ship.text.clear();
    HostLoop loop(scenario, first_flight_names(), 30.0, 4.0 / 3.0);
    const ApproachSection& section = approach_for(scenario);
    EXPECT_LT(glm::distance(loop.packet(0, {}).channels[0].eye_m, section.path_m.front()), 1e-9);
    EXPECT_LT(glm::distance(loop.packet(loop.frames(), {}).channels[0].eye_m, section.path_m.back()), 1e-9);
}

TEST(HostLoop, ChannelsHaveTheirFieldsOfView) {
    Scenario scenario = first_flight_scenario();
    scenario.channels = {
        {.name = "a", .horizontal_field_rad = radians(90.0)},
        {.name = "b", .horizontal_field_rad = radians(48.0), .vertical_field_rad = radians(36.0)},
        {.name = "c", .horizontal_field_rad = radians(48.0), .azimuth_rad = radians(-48.0)}};
    HostLoop loop(scenario, first_flight_names(), 30.0, 2.0);
    const FramePacket& packet = loop.packet(0, {});
    ASSERT_EQ(packet.channels.size(), 3U);
    EXPECT_NEAR(packet.channels[0].right_tangent, 1.0, 1e-12);
    EXPECT_NEAR(packet.channels[0].top_tangent, 0.5, 1e-12)
        << "square pixels in a picture twice as wide as high";
    EXPECT_NEAR(packet.channels[1].bottom_tangent, -std::tan(radians(18.0)), 1e-12);
    const Vec3d ahead = world_from_body(packet.channels[0].attitude)[0];
    const Vec3d starboard = world_from_body(packet.channels[2].attitude)[0];
    EXPECT_NEAR(glm::dot(ahead, starboard), std::cos(radians(48.0)), 1e-9);
    EXPECT_LT(ahead.x * starboard.y - ahead.y * starboard.x, 0.0) << "to starboard";
}

TEST(HostLoop, TheViewSignalTurnsTheHead) {
    HostLoop loop = loop_at(30.0);
    const Mat3d ahead = world_from_body(loop.packet(60, {}).channels[0].attitude);
    const auto line_of_sight = [&](double view) {
        const ChannelView& channel = loop.packet(60, with(Signal::view, view)).channels[0];
        return glm::transpose(ahead) * world_from_body(channel.attitude)[0];
    };
    EXPECT_NEAR(line_of_sight(1).y, std::sin(radians(60.0)), 1e-9) << "left";
    EXPECT_NEAR(line_of_sight(2).y, -std::sin(radians(60.0)), 1e-9) << "right";
    EXPECT_NEAR(line_of_sight(3).z, -std::sin(radians(45.0)), 1e-9) << "down";
    EXPECT_NEAR(line_of_sight(0).x, 1.0, 1e-12);
}

TEST(HostLoop, SmoothShadingOffKeepsEachListsLight) {
    HostLoop loop = loop_at(30.0);
    const FramePacket& packet = loop.packet(0, with(Signal::smooth_shading, 0));
    ASSERT_EQ(packet.lighting.size(), 2U) << "all lists but the sky";
    EXPECT_EQ(packet.lighting[0].list, 0U);
    EXPECT_EQ(packet.lighting[0].sun, 1U);
    EXPECT_EQ(packet.lighting[0].ambient, 0.35F);
    EXPECT_EQ(packet.lighting[0].diffuse, 0.65F);
    EXPECT_EQ(packet.lighting[0].colour, none);
    EXPECT_EQ(packet.lighting[0].method, ShadingMethod::no_smooth);
    EXPECT_EQ(packet.lighting[1].list, 2U);
}

TEST(HostLoop, TheSeasSunRisesWithinItsLimits) {
    HostLoop loop = loop_at(30.0);
    const auto elevation = [&](double offset) {
        return degrees(std::asin(
            static_cast<double>(loop.packet(7, with(Signal::sea_sun_elevation, offset)).suns[ocean_row].z)));
    };
    EXPECT_NEAR(elevation(radians(10.0)), 40.0, 1e-4);
    EXPECT_NEAR(elevation(radians(-4.0)), 26.0, 1e-4);
    EXPECT_NEAR(elevation(radians(-80.0)), 22.0, 1e-4);
    EXPECT_NEAR(elevation(radians(80.0)), 88.0, 1e-3);
}

TEST(HostLoop, ChangingTheSunsRateDoesNotMakeItJump) {
    HostLoop loop = loop_at(30.0);
    SignalValues signals;
    const std::uint64_t frame = 1234;
    for (const double rate : {1.5, 0.0, 3.0, 1.0}) {
        const Vec3f before = loop.packet(frame, signals).suns[ocean_row];
        signals = loop.with_sea_sun_rate(signals, rate, frame);
        EXPECT_EQ(signals[Signal::sea_sun_rate], rate);
        EXPECT_LT(glm::distance(before, loop.packet(frame, signals).suns[ocean_row]), 1e-6F) << rate;
        const Vec3f after = loop.packet(frame + 1, signals).suns[ocean_row];
        const double chord = 2.0 * std::sin(rate * radians(72.0) / 60.0) * std::cos(radians(30.0));
        EXPECT_NEAR(glm::distance(before, after), chord, 1e-6) << rate;
    }
}

TEST(HostLoop, PitchFactorAndVisibilityFactor) {
    Scenario scenario = first_flight_scenario();
    HostLoop clear(scenario, first_flight_names(), 30.0);
    const double pitch = clear.packet(100, {}).moving_objects[lph2_row].attitude.pitch_rad;
    EXPECT_NEAR(
        clear.packet(100, with(Signal::pitch_amplitude, 2)).moving_objects[lph2_row].attitude.pitch_rad,
        2.0 * pitch, 1e-15);
    EXPECT_EQ(clear.packet(100, with(Signal::pitch_amplitude, 0)).moving_objects[lph2_row].attitude.pitch_rad,
              0.0);
    EXPECT_EQ(clear.packet(0, {}).visibility_m, 0.0F) << "unlimited";
    EXPECT_EQ(clear.packet(0, with(Signal::visibility, 0.5)).visibility_m, 25000.0F);
    scenario.visibility_m = 4000.0;
    HostLoop hazy(scenario, first_flight_names(), 30.0);
    EXPECT_EQ(hazy.packet(0, {}).visibility_m, 4000.0F);
    EXPECT_EQ(hazy.packet(0, with(Signal::visibility, 0.5)).visibility_m, 2000.0F);
}

/// At the first frame, in the middle and after a day, with every signal at each of its bounds.
TEST(HostLoop, EveryPacketCanBeDrawn) {
    HostLoop loop = loop_at(30.0);
    const PacketLimits limits{.suns = 4,
                              .moving_objects = 2,
                              .lists = 3,
                              .colours = 12,
                              .alternatives = {29, 3, 29},
                              .database_id = 0x1234};
    for (const std::uint64_t frame : {0ULL, 333ULL, 2592000ULL})
        for (const SignalDefinition& each : signal_directory())
            for (const double value : {each.minimum, each.maximum})
                EXPECT_EQ(check_packet(loop.packet(frame, with(each.signal, value)), limits), "")
                    << frame << " " << each.name << " " << value;
}

TEST(HostLoop, FullDayIsAsAuthored) {
    HostLoop loop = loop_at(30.0);
    const FramePacket& packet = loop.packet(0, {});
    EXPECT_EQ(packet.time_of_day_h, 15.0F);
    EXPECT_TRUE(packet.colours.empty());
    EXPECT_TRUE(packet.lighting.empty());
    EXPECT_EQ(packet.sky, first_flight_scenario().sky);
    EXPECT_FLOAT_EQ(packet.light_points, 0.3F);
}

TEST(HostLoop, AtNightFacesAndSkyAreDarkAndLampsBright) {
    HostLoop loop = loop_at(30.0);
    const FramePacket dusk = loop.packet(0, with(Signal::time_of_day, 3.0));
    const FramePacket night = loop.packet(0, with(Signal::time_of_day, 8.0));
    EXPECT_EQ(dusk.time_of_day_h, 18.0F);
    EXPECT_EQ(night.time_of_day_h, 23.0F);
    ASSERT_EQ(night.colours.size(), 12U);
    EXPECT_EQ(night.light_points, 1.0F);
    // Row 11 is the deck's, 0 and 10 the sky's horizon and zenith.
    EXPECT_LT(night.colours[11].red, dusk.colours[11].red);
    EXPECT_GT(night.colours[11].blue, night.colours[11].red) << "night is blue";
    EXPECT_GT(dusk.colours[0].red, dusk.colours[0].blue) << "a red horizon at sunset";
    EXPECT_LT(dusk.colours[10].red, dusk.colours[10].blue) << "and a blue zenith";
    EXPECT_NEAR(dusk.sky.x * 255.0F, dusk.colours[0].red, 1.0F) << "distance fades into the horizon";
    ASSERT_EQ(night.lighting.size(), 2U) << "every list but the sky's";
    EXPECT_EQ(night.lighting[0].method, ShadingMethod::as_modelled);
    EXPECT_LT(night.lighting[1].diffuse, 0.55F);
    EXPECT_GT(night.lighting[1].ambient, 0.45F);
    SignalValues flat = with(Signal::time_of_day, 8.0);
    flat.set(Signal::smooth_shading, 0.0);
    EXPECT_EQ(loop.packet(0, flat).lighting[0].method, ShadingMethod::no_smooth);
}

TEST(HostLoop, TheDayGoesByAsAuthoredAndWraps) {
    Scenario scenario = first_flight_scenario();
    scenario.time_of_day_h = 23.5;
    scenario.hours_per_minute = 60.0;
    HostLoop loop(scenario, first_flight_names(), 30.0);
    EXPECT_FLOAT_EQ(loop.packet(0, {}).time_of_day_h, 23.5F);
    EXPECT_FLOAT_EQ(loop.packet(30, {}).time_of_day_h, 0.5F);
}

TEST(HostLoop, AllocatesNothingAfterTheFirstFrame) {
    HostLoop loop = loop_at(30.0);
    const SignalValues plain;
    const SignalValues flat = with(Signal::smooth_shading, 0);
    const SignalValues night = with(Signal::time_of_day, 9);
    loop.packet(0, plain);
    const std::uint64_t before = allocations();
    for (std::uint64_t frame = 1; frame < 200; ++frame)
        loop.packet(frame, frame % 3 == 0 ? night : frame % 3 == 1 ? plain : flat);
    EXPECT_EQ(allocations(), before);
}

} // namespace
} // namespace linkdig::host
