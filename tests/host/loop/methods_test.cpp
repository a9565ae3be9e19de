// The report's methods in the packet stream: slots, priorities, normals, suns, and a flight by hand.

#include "host/loop/host_loop.h"
#include "host/loop/host_values.h"
#include "host/packet/packet_bytes.h"
#include "tests/support/allocation_count.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace linkdig::host {
namespace {

using testing::HasSubstr;

/// A ship with every slot, a sea with a tile of two by two, and a pier.
NameDirectory whole_directory() {
    NameDirectory names;
    names.suns = {"world", "ocean", "churn"};
    names.moving_objects = {"lph2", "lph2.cam_port", "lph2.cam_starboard"};
    names.slots = {{"lph2.hull_below", 2},
                   {"lph2.box", 3},
                   {"lph2.wedge_bow", 11},
                   {"lph2.wedge_stern", 6},
                   {"lph2.bow_wake_port", 29},
                   {"bow_wake_port", 28},
                   {"lph2.bow_wake_starboard", 29},
                   {"lph2.solid_bow_wake", 29},
                   {"lph2.v_wake", 3},
                   {"lph2.churn", 2},
                   {"lph2.cam", 2},
                   {"lph2.lights", 2}};
    names.lists = {{"sea", 1, 0.35F, 0.65F}};
    names.clusters = {{"sea", 20, none, {}, {}},
                      {"lph2", 10, 0, {0, 0, 10}, {90, 13, 10}},
                      {"pier", 10, none, {600, 0, 2}, {50, 10, 2}}};
    names.tiles = {
        {0, {Vec3f(0.6F, 0, 0.8F), Vec3f(0, 0.6F, 0.8F), Vec3f(-0.6F, 0, 0.8F), Vec3f(0, -0.6F, 0.8F)}}};
    return names;
}

Scenario one_ship() {
    Scenario scenario;
    scenario.duration_s = 20.0;
    scenario.suns.push_back({.sun = {"world", {}}, .elevation_rad = 0.7});
    scenario.suns.push_back({.sun = {"ocean", {}},
                             .azimuth_rad = 0.3,
                             .elevation_rad = 0.5,
                             .azimuth_rate_rad_s = two_pi / 5.0,
                             .least_elevation_rad = 0.1,
                             .greatest_elevation_rad = 1.5});
    scenario.suns.push_back({.sun = {"churn", {}},
                             .elevation_rad = 0.5,
                             .azimuth_rate_rad_s = 10.0,
                             .greatest_elevation_rad = 1.5});
    ShipSection ship;
    ship.moving_object = {"lph2", {}};
    ship.speed_mps = 6.0;
    scenario.ships.push_back(ship);
    scenario.own_ship.kind = OwnShipSection::Kind::fixed;
    scenario.own_ship.position_m = {-300, 50, 20};
    scenario.channels.push_back({.name = "ahead", .horizontal_field_rad = 1.0});
    return scenario;
}

/// The slot's alternative in a packet, by name; -1: the packet says nothing.
int pointed(const FramePacket& packet, const char* slot) {
    const auto index = whole_directory().find_slot(slot);
    int found = -1;
    for (const Substitution& each : packet.substitutions)
        if (each.slot == index) found = static_cast<int>(each.index);
    return found;
}

SignalValues with(Signal signal, double value) {
    SignalValues values;
    values.set(signal, value);
    return values;
}

TEST(Methods, NothingIsSaidUntilAMethodIsNamed) {
    HostLoop loop(one_ship(), whole_directory(), 30.0);
    const FramePacket& packet = loop.packet(5, {});
    EXPECT_TRUE(packet.substitutions.empty());
    EXPECT_TRUE(packet.priorities.empty());
    EXPECT_TRUE(packet.host_values.empty());
    EXPECT_FALSE(packet.moving_objects[1].visible);
}

TEST(Methods, EachOccultingHasItsSlots) {
    struct Expected {
        Occulting method;
        int hull, box;
        bool behind_the_sea;
    };
    for (const Expected& each :
         {Expected{Occulting::none, 1, 0, true}, Expected{Occulting::waterline, 0, 0, false},
          Expected{Occulting::priority, 1, 0, false}, Expected{Occulting::box, 1, 1, false},
          Expected{Occulting::fitted_box, 1, 2, false}, Expected{Occulting::wedges, 0, 0, false}}) {
        Scenario scenario = one_ship();
        scenario.ships[0].methods.occulting = each.method;
        HostLoop by_scenario(scenario, whole_directory(), 30.0);
        HostLoop by_signal(one_ship(), whole_directory(), 30.0);
        const double signal = static_cast<double>(each.method) + 1.0;
        for (const FramePacket& packet :
             {by_scenario.packet(0, {}), by_signal.packet(0, with(Signal::occulting, signal))}) {
            EXPECT_EQ(pointed(packet, "lph2.hull_below"), each.hull) << signal;
            EXPECT_EQ(pointed(packet, "lph2.box"), each.box) << signal;
            EXPECT_EQ(pointed(packet, "lph2.wedge_bow"), 0);
            ASSERT_EQ(packet.priorities.size(), each.behind_the_sea ? 1U : 0U);
            if (each.behind_the_sea) {
                EXPECT_EQ(packet.priorities[0].cluster, 1U);
                EXPECT_EQ(packet.priorities[0].number, 20);
            }
        }
    }
}

TEST(Methods, AWedgeIsNeverSmallerThanTheGap) {
    EXPECT_EQ(wedge_index(0.0, 10), 0U);
    EXPECT_EQ(wedge_index(-0.1, 10), 0U);
    EXPECT_EQ(wedge_index(radians(0.01), 10), 1U);
    EXPECT_EQ(wedge_index(radians(1.0), 10), 1U);
    EXPECT_EQ(wedge_index(radians(1.01), 10), 2U);
    EXPECT_EQ(wedge_index(radians(10.0), 10), 10U);
    EXPECT_EQ(wedge_index(radians(45.0), 10), 10U);
    EXPECT_EQ(wedge_index(radians(5.0), 0), 0U);
}

TEST(Methods, PitchDrivesTheWedgesAtTheEndThatRises) {
    Scenario scenario = one_ship();
    scenario.ships[0].methods.occulting = Occulting::wedges;
    scenario.ships[0].motion = MotionSection{};
    scenario.ships[0].motion->history = {{0.0, {0, 0, 0, 0, radians(-10.0), 0}},
                                         {20.0, {0, 0, 0, 0, radians(10.0), 0}}};
    HostLoop loop(scenario, whole_directory(), 30.0);
    EXPECT_EQ(pointed(loop.packet(0, {}), "lph2.wedge_stern"), 5);
    EXPECT_EQ(pointed(loop.packet(0, {}), "lph2.wedge_bow"), 0);
    EXPECT_EQ(pointed(loop.packet(450, {}), "lph2.wedge_bow"), 5) << "5 degrees bow up of 10 in ten wedges";
    EXPECT_EQ(pointed(loop.packet(450, {}), "lph2.wedge_stern"), 0);
}

TEST(Methods, WakesAreSumsThatSignalsChangeOver) {
    Scenario scenario = one_ship();
    Wakes wakes{};
    wakes[static_cast<std::size_t>(Wake::face_substitution)] = true;
    wakes[static_cast<std::size_t>(Wake::churned)] = true;
    scenario.ships[0].methods.wakes = wakes;
    HostLoop loop(scenario, whole_directory(), 30.0);
    const FramePacket both = loop.packet(7, {});
    EXPECT_EQ(pointed(both, "lph2.bow_wake_port"), 3) << "three frames a face: the third, after nothing";
    EXPECT_EQ(pointed(both, "lph2.bow_wake_starboard"), 3);
    EXPECT_EQ(pointed(both, "bow_wake_port"), -1) << "the ship's own slot comes first";
    EXPECT_EQ(pointed(both, "lph2.churn"), 1);
    EXPECT_EQ(pointed(both, "lph2.v_wake"), 0);
    EXPECT_EQ(pointed(loop.packet(7, with(Signal::churned, 1)), "lph2.churn"), 0);
    EXPECT_EQ(pointed(loop.packet(7, with(Signal::blended_v, 1)), "lph2.v_wake"), 2);
    EXPECT_EQ(pointed(loop.packet(7, with(Signal::face_substitution, 1)), "lph2.bow_wake_port"), 0);
}

TEST(Methods, TheFacesFollowOneAnotherAndWrap) {
    Scenario scenario = one_ship();
    Wakes wakes{};
    wakes[static_cast<std::size_t>(Wake::face_substitution)] = true;
    scenario.ships[0].methods.wakes = wakes;
    HostLoop loop(scenario, whole_directory(), 30.0);
    for (std::uint64_t frame = 0; frame < 200; ++frame)
        ASSERT_EQ(pointed(loop.packet(frame, {}), "lph2.bow_wake_port"), 1 + static_cast<int>(frame / 3 % 28))
            << frame;
}

TEST(Methods, CamsRideBesideTheShipAndRoll) {
    Scenario scenario = one_ship();
    Wakes wakes{};
    wakes[static_cast<std::size_t>(Wake::cam)] = true;
    scenario.ships[0].methods.wakes = wakes;
    HostLoop loop(scenario, whole_directory(), 30.0);
    const FramePacket& packet = loop.packet(15, {});
    const Vec3d ship = packet.moving_objects[0].waterline_position_m;
    EXPECT_TRUE(packet.moving_objects[1].visible);
    EXPECT_LT(glm::distance(packet.moving_objects[1].position_m - ship, Vec3d(63.5, 8.1, 0)), 1e-9);
    EXPECT_LT(glm::distance(packet.moving_objects[2].position_m - ship, Vec3d(63.5, -8.1, 0)), 1e-9);
    EXPECT_NEAR(packet.moving_objects[1].attitude.roll_rad, -pi / 2.0, 1e-9) << "a quarter of two seconds";
    EXPECT_NEAR(packet.moving_objects[2].attitude.roll_rad, pi / 2.0, 1e-9);
    EXPECT_FALSE(loop.packet(15, with(Signal::cam, 1)).moving_objects[1].visible);
}

/// Intensities are the same: n . s for each normal, whichever of the two turns.
TEST(Methods, TurnedNormalsGiveTheIntensitiesOfATurnedSun) {
    HostLoop loop(one_ship(), whole_directory(), 30.0);
    const std::vector<Vec3f> modelled = whole_directory().tiles[0].normals;
    for (const std::uint64_t frame : {0ULL, 1ULL, 40ULL, 149ULL}) {
        const Vec3f sun = loop.packet(frame, {}).suns[1];
        EXPECT_TRUE(loop.packet(frame, {}).normal_updates.empty());
        const FramePacket& packet = loop.packet(frame, with(Signal::sea_method, 1));
        ASSERT_EQ(packet.normal_updates.size(), 1U);
        ASSERT_EQ(packet.normal_updates[0].normals.size(), modelled.size());
        EXPECT_NEAR(std::atan2(packet.suns[1].y, packet.suns[1].x), 0.3, 1e-6) << "the sun stands";
        for (std::size_t i = 0; i < modelled.size(); ++i)
            EXPECT_NEAR(glm::dot(packet.normal_updates[0].normals[i], packet.suns[1]),
                        glm::dot(modelled[i], sun), 1e-6);
    }
}

TEST(Methods, NormalsAreHeldBetweenUpdates) {
    Scenario scenario = one_ship();
    scenario.sea_method = SeaMethod::normals;
    scenario.normals_every = 4;
    HostLoop loop(scenario, whole_directory(), 30.0);
    const Vec3f fourth = loop.packet(4, {}).normal_updates[0].normals[0];
    EXPECT_EQ(loop.packet(7, {}).normal_updates[0].normals[0], fourth);
    EXPECT_NE(loop.packet(8, {}).normal_updates[0].normals[0], fourth);
    EXPECT_NE(loop.packet(5, with(Signal::normals_every, 1)).normal_updates[0].normals[0], fourth);
}

TEST(Methods, NothingIsAllocatedWhateverTheMethod) {
    HostLoop loop(one_ship(), whole_directory(), 30.0);
    SignalValues signals;
    for (const Signal each :
         {Signal::sea_method, Signal::churned, Signal::cam, Signal::hands_on, Signal::smooth_shading})
        signals.set(each, signals.on(each) ? 0.0 : 1.0);
    signals.set(Signal::occulting, 1.0);
    loop.packet(0, {});
    loop.packet(1, signals);
    loop.packet(2, {});
    const std::uint64_t before = allocations();
    for (std::uint64_t frame = 3; frame < 40; ++frame)
        loop.packet(frame, frame % 2 == 0 ? signals : SignalValues{});
    EXPECT_EQ(allocations(), before);
}

/// Ten minutes at 60 Hz: the sun's phase is that of the frame number, and only the ocean's sun and the churned water's move.
TEST(Methods, TenMinutesWithoutDrift) {
    HostLoop loop(one_ship(), whole_directory(), 60.0);
    const Vec3f world = loop.packet(0, {}).suns[0];
    double worst = 0.0;
    for (std::uint64_t frame = 0; frame <= 36000; ++frame) {
        const FramePacket& packet = loop.packet(frame, {});
        ASSERT_EQ(packet.frame, frame);
        ASSERT_EQ(packet.suns[0], world);
        // 300 frames a turn, in whole numbers.
        const double expected = 0.3 + two_pi * static_cast<double>(frame % 300) / 300.0;
        const double found = std::atan2(packet.suns[1].y, packet.suns[1].x);
        worst = std::max(worst, std::fabs(std::remainder(found - expected, two_pi)));
        ASSERT_NEAR(packet.suns[1].z, std::sin(0.5), 1e-6);
    }
    EXPECT_LT(worst, 1e-6) << "single precision of the packet's vector";
}

TEST(Methods, TheOtherIncrementReflectsAndDoesNotJump) {
    HostLoop loop(one_ship(), whole_directory(), 30.0);
    SignalValues signals = loop.with_sea_sun_elevation_rate({}, 0.2, 100);
    const auto elevation = [&](std::uint64_t frame) {
        return std::asin(static_cast<double>(loop.packet(frame, signals).suns[1].z));
    };
    EXPECT_NEAR(elevation(100), 0.5, 1e-6);
    EXPECT_NEAR(elevation(130), 0.7, 1e-6);
    EXPECT_NEAR(elevation(100 + 30 * 7), 1.1, 1e-6) << "1.9, reflected at 1.5";
    signals = loop.with_sea_sun_elevation_rate(signals, 0.0, 130);
    EXPECT_NEAR(elevation(130), 0.7, 1e-6);
    EXPECT_NEAR(elevation(500), 0.7, 1e-6);
}

TEST(Methods, SeaStatesAreElevationsOfTheOceansSunAlone) {
    HostLoop loop(one_ship(), whole_directory(), 30.0);
    const FramePacket before = loop.packet(9, {});
    for (const auto& [value, degrees_up] :
         {std::pair{1.0, 90.0}, std::pair{2.0, 60.0}, std::pair{3.0, 24.0}}) {
        const FramePacket& packet = loop.packet(9, with(Signal::sea_state, value));
        EXPECT_NEAR(degrees(std::asin(static_cast<double>(packet.suns[1].z))), degrees_up, 0.03);
        EXPECT_EQ(packet.suns[0], before.suns[0]);
        EXPECT_EQ(packet.suns[2], before.suns[2]);
    }
    EXPECT_EQ(loop.packet(9, with(Signal::sea_state, 3)).sea.state, 3.0F);
}

TEST(Methods, ATrackThroughAPierIsAMistake) {
    Scenario scenario = one_ship();
    scenario.ships[0].moving_object.at = {"test.toml", 7, 3};
    scenario.duration_s = 120.0;
    try {
        const HostLoop loop(scenario, whole_directory(), 30.0);
        FAIL() << "she sailed through it";
    } catch (const std::invalid_argument& refused) {
        // Her bow is 90 m ahead, the pier's near end at 550 m: 460 m at 6 m/s.
        EXPECT_THAT(refused.what(),
                    HasSubstr("test.toml:7:3: error: the track of \"lph2\" leads through \"pier\" after 7"));
    }
    scenario.ships[0].position_m = {0, 100, 0};
    EXPECT_NO_THROW(HostLoop(scenario, whole_directory(), 30.0)) << "100 m abeam";
}

TEST(Methods, TheOwnShipStandsBesideAShip) {
    Scenario scenario = one_ship();
    scenario.own_ship.beside = Name{"lph2", {}};
    HostLoop loop(scenario, whole_directory(), 30.0);
    EXPECT_LT(glm::distance(loop.packet(300, {}).channels[0].eye_m, Vec3d(-240, 50, 20)), 1e-9);
}

/// A flight with controls, taken up again from one of its packets: the same bytes as if it had never been left.
TEST(Methods, AFlightByHandIsTakenUpWhereItWasLeft) {
    const auto controls = [](std::uint64_t frame) {
        SignalValues signals;
        signals.set(Signal::hands_on, frame >= 20 ? 1.0 : 0.0);
        signals.set(Signal::stick_fore, frame >= 25 && frame < 60 ? 0.6 : -0.2);
        signals.set(Signal::pedals_right, frame > 40 ? 0.5 : 0.0);
        signals.set(Signal::churned, frame > 50 ? 1.0 : 0.0);
        return signals;
    };
    HostLoop whole(one_ship(), whole_directory(), 30.0);
    std::vector<std::vector<std::uint8_t>> bytes;
    for (std::uint64_t frame = 0; frame < 120; ++frame)
        bytes.push_back(encode_packet(whole.packet(frame, controls(frame))));
    EXPECT_NE(bytes[119], bytes[19]);
    for (const std::uint64_t left : {0ULL, 19ULL, 33ULL, 100ULL}) {
        const PacketResult saved = decode_packet(bytes[left]);
        ASSERT_TRUE(saved.packet) << saved.error;
        EXPECT_EQ(signals_of(*saved.packet), controls(left));
        HostLoop again(one_ship(), whole_directory(), 30.0);
        again.resume(*saved.packet);
        for (std::uint64_t frame = left; frame < 120; ++frame)
            ASSERT_EQ(encode_packet(again.packet(frame, controls(frame))), bytes[frame])
                << "left " << left << ", frame " << frame;
    }
    const PacketResult other = decode_packet(bytes[60]);
    EXPECT_TRUE(own_ship_of(*other.packet).has_value());
    EXPECT_FALSE(own_ship_of(*decode_packet(bytes[0]).packet).has_value());
}

/// The recorded signals alone give the recorded packets again.
TEST(Methods, TheRecordedSignalsMakeTheSamePackets) {
    Scenario scenario = one_ship();
    scenario.own_ship.kind = OwnShipSection::Kind::flown;
    HostLoop first(scenario, whole_directory(), 30.0);
    HostLoop second(scenario, whole_directory(), 30.0);
    for (std::uint64_t frame = 0; frame < 90; ++frame) {
        SignalValues signals;
        signals.set(Signal::stick_right, std::sin(static_cast<double>(frame)));
        const FramePacket flown = first.packet(frame, signals);
        ASSERT_EQ(encode_packet(second.packet(frame, signals_of(flown))), encode_packet(flown)) << frame;
    }
    EXPECT_NE(first.packet(89, {}).channels[0].eye_m.y, 50.0);
}

TEST(Methods, LightsBurnFromDusk) {
    const auto lights = [](ShipLights said, double hour) {
        Scenario scenario = one_ship();
        scenario.time_of_day_h = hour;
        scenario.ships[0].methods.lights = said;
        HostLoop loop(scenario, whole_directory(), 30.0);
        return pointed(loop.packet(3, {}), "lph2.lights");
    };
    EXPECT_EQ(lights(ShipLights::from_dusk, 12.0), -1); // the slot stays empty
    EXPECT_EQ(lights(ShipLights::from_dusk, 17.9), 1);
    EXPECT_EQ(lights(ShipLights::from_dusk, 2.0), 1);
    EXPECT_EQ(lights(ShipLights::on, 12.0), 1);
    EXPECT_EQ(lights(ShipLights::off, 2.0), -1);
}

TEST(Methods, LightsThatTheShipHasNotAreTold) {
    Scenario scenario = one_ship();
    scenario.time_of_day_h = 2.0;
    NameDirectory dark = whole_directory();
    dark.slots.pop_back();
    HostLoop unlit(scenario, dark, 30.0); // nothing to light is no mistake...
    EXPECT_TRUE(unlit.packet(0, {}).substitutions.empty());
    scenario.ships[0].methods.lights = ShipLights::on; // ...but then nobody may ask for it
    try {
        const HostLoop loop(scenario, dark, 30.0);
        FAIL() << "not refused";
    } catch (const std::invalid_argument& error) {
        EXPECT_THAT(error.what(),
                    HasSubstr("\"lights\" cannot be shown: the database lacks the slot \"lph2.lights\""));
    }
}

} // namespace
} // namespace linkdig::host
