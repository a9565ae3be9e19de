// Whoever writes a rate: what it moves does not jump.

#include "host/loop/steady_rates.h"

#include "tests/host/loop/first_flight.h"

#include <gtest/gtest.h>

namespace linkdig::host {
namespace {

constexpr std::size_t ocean_row = 1;
constexpr std::size_t lph2_row = 1;

class SteadyRatesTest : public testing::Test {
protected:
    /// The packet of the next frame.
    const FramePacket& next() {
        const SignalValues values = rates_.follow(store_.snapshot(), loop_, frame_, store_);
        return loop_.packet(values.on(Signal::reset) ? frame_ = 0 : ++frame_, values);
    }
    /// How far ship and sun get from this frame to the next.
    struct Steps {
        double ship_m = 0.0;
        double sun = 0.0;
    };
    Steps step() {
        const Vec3d ship = packet_.moving_objects[lph2_row].waterline_position_m;
        const Vec3f sun = packet_.suns[ocean_row];
        packet_ = next();
        return {glm::distance(ship, packet_.moving_objects[lph2_row].waterline_position_m),
                static_cast<double>(glm::distance(sun, packet_.suns[ocean_row]))};
    }

    HostLoop loop_{first_flight_scenario(), first_flight_names(), 30.0};
    SteadyRates rates_;
    SignalStore store_;
    std::uint64_t frame_ = 500;
    FramePacket packet_;
};

TEST_F(SteadyRatesTest, APanelThatWritesRatesAloneMovesNothing) {
    store_.write(Signal::ship_motion, 0.0);
    packet_ = next();
    const Steps before = step();
    store_.write(Signal::sea_sun_rate, 2.0);
    store_.write(Signal::ship_speed, 0.5);
    const Steps first = step();
    EXPECT_NEAR(first.ship_m, 0.5 * before.ship_m, 1e-6);
    EXPECT_NEAR(first.sun, 2.0 * before.sun, 1e-3);
    const Steps second = step();
    EXPECT_NEAR(second.ship_m, first.ship_m, 1e-6);
    EXPECT_NEAR(second.sun, first.sun, 1e-3);
    EXPECT_NE(store_.value(Signal::ship_way), 0.0);
}

TEST_F(SteadyRatesTest, AResetKeepsNoPhase) {
    packet_ = next();
    store_.write(Signal::ship_speed, 2.0);
    store_.write(Signal::reset, 1.0);
    packet_ = next();
    EXPECT_EQ(packet_.frame, 0U);
    EXPECT_EQ(store_.value(Signal::ship_way), 0.0);
    EXPECT_EQ(packet_.moving_objects[lph2_row].waterline_position_m,
              loop_.packet(0, SignalValues()).moving_objects[lph2_row].waterline_position_m);
}

TEST_F(SteadyRatesTest, ASavedFlightGoesOnWithItsOwnRates) {
    SignalValues saved;
    saved.set(Signal::ship_speed, 1.5);
    saved.set(Signal::ship_way, -3.0);
    store_.assign(saved);
    rates_.resume(saved);
    next();
    EXPECT_EQ(store_.value(Signal::ship_way), -3.0);
}

} // namespace
} // namespace linkdig::host
