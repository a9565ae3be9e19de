#include "host/loop/instruments.h"

#include "tests/host/loop/first_flight.h"

#include <gtest/gtest.h>

#include <cmath>

namespace linkdig::host {
namespace {

constexpr std::size_t lph2_row = 1;

class ReadInstruments : public testing::Test {
protected:
    const FramePacket& read(std::uint64_t frame, const SignalValues& signals = {},
                            std::uint64_t overruns = 0) {
        const FramePacket& packet = loop_.packet(frame, signals);
        instruments_.read(loop_, packet, overruns, store_);
        return packet;
    }
    double shown(Indication indication) const { return store_.value(indication); }

    HostLoop loop_{first_flight_scenario(), first_flight_names(), 30.0};
    Instruments instruments_{loop_};
    IndicationStore store_;
};

TEST_F(ReadInstruments, NothingIsShownBeforeTheFirstFrame) {
    for (const IndicationDefinition& each : indication_directory()) {
        EXPECT_TRUE(std::isnan(shown(each.indication))) << each.name;
        EXPECT_EQ(find_indication(each.name), each.indication);
    }
    EXPECT_EQ(find_indication("altitude"), std::nullopt);
}

TEST_F(ReadInstruments, OwnShipsHeightHeadingAndSpeedAreThoseOfThePackets) {
    const Vec3d before = read(100).channels[0].eye_m;
    const FramePacket& packet = read(103);
    const Vec3d now = packet.channels[0].eye_m;
    EXPECT_EQ(shown(Indication::altitude_m), now.z);
    EXPECT_NEAR(shown(Indication::altitude_ft), now.z / 0.3048, 1e-9);
    EXPECT_NEAR(shown(Indication::climb_fpm), (now.z - before.z) * 10.0 * 60.0 / 0.3048, 1e-6);
    EXPECT_NEAR(shown(Indication::speed_kt),
                std::hypot(now.x - before.x, now.y - before.y) * 10.0 * 3600 / 1852, 1e-6);
    const double heading = 90.0 - degrees(loop_.own_ship().attitude.heading_rad);
    EXPECT_NEAR(std::remainder(shown(Indication::heading) - heading, 360.0), 0.0, 1e-9);
    EXPECT_GE(shown(Indication::heading), 0.0);
}

TEST_F(ReadInstruments, TheViewIsNoPartOfTheHeading) {
    read(10);
    const double heading = shown(Indication::heading);
    SignalValues left;
    left.set(Signal::view, 1.0);
    read(10, left);
    EXPECT_EQ(shown(Indication::heading), heading);
}

TEST_F(ReadInstruments, TheShipsFiguresAreThePackets) {
    read(0);
    const FramePacket& packet = read(60);
    const MovingObject& ship = packet.moving_objects[lph2_row];
    EXPECT_NEAR(shown(Indication::ship_pitch), degrees(ship.attitude.pitch_rad), 1e-12);
    EXPECT_NEAR(shown(Indication::ship_roll), degrees(ship.attitude.roll_rad), 1e-12);
    EXPECT_NEAR(shown(Indication::range_m), glm::distance(ship.position_m, packet.channels[0].eye_m), 1e-9);
    EXPECT_EQ(shown(Indication::sea_state), packet.sea.state);
    EXPECT_TRUE(std::isnan(shown(Indication::visibility_m))) << "unlimited";
}

TEST_F(ReadInstruments, ADeckIsReadyOnceItHasLainQuietlyForASecond) {
    SignalValues still;
    still.set(Signal::ship_motion, 0.0);
    for (std::uint64_t frame = 0; frame < 30; ++frame) {
        read(frame, still);
        EXPECT_EQ(shown(Indication::deck_ready), 0.0) << frame;
    }
    read(30, still);
    EXPECT_EQ(shown(Indication::deck_ready), 1.0);
    SignalValues wild;
    wild.set(Signal::ship_motion, 2.0);
    wild.set(Signal::pitch_amplitude, 2.0);
    std::uint64_t frame = 31;
    while (std::abs(read(frame, wild).moving_objects[lph2_row].attitude.pitch_rad) <= quiet_pitch_rad)
        ASSERT_LT(++frame, 1000U) << "she never pitches";
    EXPECT_EQ(shown(Indication::deck_ready), 0.0) << "at once";
}

TEST_F(ReadInstruments, ALateUpdateShowsForASecond) {
    read(0, {}, 0);
    EXPECT_EQ(shown(Indication::overrun), 0.0);
    read(2, {}, 1);
    for (std::uint64_t frame = 3; frame < 32; ++frame) {
        read(frame, {}, 1);
        EXPECT_EQ(shown(Indication::overrun), 1.0) << frame;
    }
    read(32, {}, 1);
    EXPECT_EQ(shown(Indication::overrun), 0.0);
    EXPECT_EQ(shown(Indication::overruns), 1.0);
}

TEST_F(ReadInstruments, ShipsAndTheirOwnShipGoAtTheSpeedThatIsAskedFor) {
    read(0);
    read(30);
    const double speed = shown(Indication::ship_speed_kt);
    EXPECT_GT(speed, 5.0);
    SignalValues half;
    half.set(Signal::ship_motion, 0.0);
    const auto advance = [&](const SignalValues& signals) {
        const Vec3d before = read(60, signals).moving_objects[lph2_row].position_m;
        return glm::distance(read(61, signals).moving_objects[lph2_row].position_m, before);
    };
    const double full_m = advance(half);
    half.set(Signal::ship_speed, 0.5);
    EXPECT_NEAR(advance(half), 0.5 * full_m, 1e-9);
    SignalValues stopped = half;
    stopped.set(Signal::ship_speed, 0.0);
    EXPECT_EQ(advance(stopped), 0.0);
}

} // namespace
} // namespace linkdig::host
