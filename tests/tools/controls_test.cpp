#include "tools/fly/controls.h"

#include "host/loop/simulation_counter.h"
#include "host/loop/steady_rates.h"

#include <gmock/gmock.h>

namespace linkdig::tools {
namespace {

using host::Signal;
using host::SignalStore;

/// One ship, one approach to it, and one sun that turns once in ten seconds.
host::HostLoop small_loop() {
    host::Scenario scenario;
    scenario.duration_s = 20.0;
    scenario.suns.push_back({.sun = {"ocean", {}},
                             .elevation_rad = 0.5,
                             .azimuth_rate_rad_s = two_pi / 10.0,
                             .least_elevation_rad = 0.0,
                             .greatest_elevation_rad = 1.5});
    scenario.ships.push_back(
        {.moving_object = {"ship", {}}, .position_m = {}, .heading_rad = 0, .speed_mps = 8, .motion = {}});
    scenario.approaches.push_back(
        {.ship = {"ship", {}},
         .duration_s = 20.0,
         .path_m = {Vec3d(-400, 0, 50), Vec3d(-300, 0, 40), Vec3d(-200, 0, 30), Vec3d(-100, 0, 20)},
         .first_aim_m = {},
         .last_aim_m = {}});
    for (const char* channel : {"ahead", "left"})
        scenario.channels.push_back(
            {.name = channel, .horizontal_field_rad = 1.0, .vertical_field_rad = 0.8});
    database::NameDirectory directory;
    directory.suns = {"ocean"};
    directory.moving_objects = {"ship"};
    return {scenario, directory, 30.0};
}

class Controls : public testing::Test {
protected:
    void press(Action action, int times = 1) {
        for (int i = 0; i < times; ++i)
            apply(action, loop_, signals_, screen_);
    }
    /// The frame on the screen after the next update.
    std::uint64_t update() {
        return frame_ = counter_.next(rates_.follow(signals_.snapshot(), loop_, frame_, signals_));
    }
    host::HostLoop loop_ = small_loop();
    host::SimulationCounter counter_;
    std::uint64_t frame_ = 0;
    SignalStore signals_;
    host::SteadyRates rates_;
    Screen screen_;
};

TEST_F(Controls, PauseFreezesAndGoesOn) {
    update();
    EXPECT_EQ(update(), 1U);
    press(Action::pause);
    EXPECT_EQ(update(), 1U);
    press(Action::pause);
    EXPECT_EQ(update(), 2U);
}

TEST_F(Controls, TheFirstStepFreezesTheNextOnesStep) {
    update();
    press(Action::step);
    EXPECT_EQ(update(), 0U);
    press(Action::step);
    EXPECT_EQ(update(), 1U);
    EXPECT_EQ(update(), 1U) << "one press, one frame";
}

TEST_F(Controls, SunKeysAreInverseAndBounded) {
    press(Action::sun_up);
    EXPECT_NEAR(signals_.value(Signal::sea_sun_elevation), 0.0349066, 1e-6);
    press(Action::sun_down);
    EXPECT_EQ(signals_.value(Signal::sea_sun_elevation), 0.0)
        << "exactly: the picture must come back bit by bit";
    press(Action::sun_down, 1000);
    EXPECT_EQ(signals_.value(Signal::sea_sun_elevation), host::definition(Signal::sea_sun_elevation).minimum);
}

TEST_F(Controls, FourPressesStopTheSeasSun) {
    press(Action::sea_sun_slower, 4);
    EXPECT_EQ(signals_.value(Signal::sea_sun_rate), 0.0);
    press(Action::sea_sun_slower);
    EXPECT_EQ(signals_.value(Signal::sea_sun_rate), 0.0);
    press(Action::sea_sun_faster, 4);
    EXPECT_EQ(signals_.value(Signal::sea_sun_rate), 1.0);
}

TEST_F(Controls, TheSeaChangesItsPaceWithoutAJump) {
    for (int i = 0; i < 78; ++i)
        update();
    const Vec3f before = loop_.packet(frame_, standing(signals_)).suns[0];
    const Vec3f unchanged = loop_.packet(frame_ + 1, standing(signals_)).suns[0];
    const std::uint64_t frame = frame_;
    press(Action::sea_sun_faster, 4);
    update();
    const Vec3f after = loop_.packet(frame, standing(signals_)).suns[0];
    const Vec3f faster = loop_.packet(frame + 1, standing(signals_)).suns[0];
    EXPECT_NEAR(glm::length(after - before), 0.0, 1e-6);
    EXPECT_NEAR(glm::length(faster - before), 2.0 * glm::length(unchanged - before), 1e-4);
}

TEST_F(Controls, ViewsAndShading) {
    const auto view = [this] { return std::string(view_name(signals_.snapshot())); };
    EXPECT_EQ(view(), "ahead");
    press(Action::view_left);
    EXPECT_EQ(view(), "left");
    press(Action::view_right);
    EXPECT_EQ(view(), "right");
    press(Action::view_down);
    EXPECT_EQ(view(), "down");
    press(Action::smooth_shading);
    EXPECT_EQ(signals_.value(Signal::smooth_shading), 0.0);
}

TEST_F(Controls, TheHourGoesOnAndBack) {
    press(Action::later, 3);
    EXPECT_EQ(signals_.value(Signal::time_of_day), 3 * hour_step);
    press(Action::earlier, 5);
    EXPECT_EQ(signals_.value(Signal::time_of_day), -2 * hour_step);
}

TEST_F(Controls, ResetPutsBackEverythingButThePause) {
    update();
    update();
    press(Action::pause);
    for (const Action action :
         {Action::sun_up, Action::sea_sun_faster, Action::later, Action::view_down, Action::smooth_shading})
        press(action);
    press(Action::reset);
    EXPECT_EQ(update(), 0U);
    EXPECT_EQ(update(), 0U) << "still frozen";
    host::SignalValues expected;
    expected.set(Signal::freeze, 1.0);
    EXPECT_EQ(standing(signals_), expected);
}

TEST_F(Controls, AResetFlightIsStillRecorded) {
    press(Action::record);
    press(Action::reset);
    EXPECT_EQ(signals_.value(Signal::record), 1.0);
    press(Action::record);
    EXPECT_EQ(signals_.value(Signal::record), 0.0);
}

TEST_F(Controls, ShipsChangeTheirSpeedWithoutAJump) {
    for (int i = 0; i < 50; ++i)
        update();
    const auto ahead_m = [&](std::uint64_t frame) {
        return loop_.packet(frame, standing(signals_)).moving_objects[0].position_m.x;
    };
    const std::uint64_t frame = frame_;
    const double before = ahead_m(frame);
    const double step = ahead_m(frame + 1) - before;
    EXPECT_GT(step, 0.1);
    press(Action::ship_faster, 5);
    update();
    EXPECT_NEAR(ahead_m(frame), before, 1e-9);
    EXPECT_NEAR(ahead_m(frame + 1) - before, 1.5 * step, 1e-9);
    press(Action::ship_slower, 40);
    EXPECT_EQ(signals_.value(Signal::ship_speed), 0.0);
    update();
    EXPECT_NEAR(ahead_m(frame_ + 9), ahead_m(frame_), 1e-9) << "she has stopped";
}

TEST_F(Controls, TheLastChannelIsFollowedByTheFirst) {
    press(Action::next_channel);
    EXPECT_EQ(signals_.value(Signal::channel_select), 1.0);
    press(Action::next_channel);
    EXPECT_EQ(signals_.value(Signal::channel_select), 0.0);
}

TEST_F(Controls, HelpAndQuitAreNoSignals) {
    const host::SignalValues before = standing(signals_);
    press(Action::help);
    EXPECT_FALSE(screen_.help);
    press(Action::help);
    EXPECT_TRUE(screen_.help);
    press(Action::quit);
    EXPECT_TRUE(screen_.quit);
    EXPECT_EQ(standing(signals_), before);
}

} // namespace
} // namespace linkdig::tools
