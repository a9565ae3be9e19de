#include "host/loop/frame_clock.h"
#include "host/loop/simulation_counter.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

namespace linkdig::host {
namespace {

/// Time that passes only when it is told to.
class FakeTime final : public TimeSource {
public:
    double now_s() override { return now; }
    void sleep_until(double time_s) override {
        ++sleeps;
        if (time_s > now) now = time_s;
    }
    double now = 100.0;
    int sleeps = 0;
};

TEST(FrameClock, RefusesARateThatIsNone) {
    EXPECT_THROW(FrameClock{0.0}, std::invalid_argument);
    EXPECT_THROW(FrameClock{-1.0}, std::invalid_argument);
    EXPECT_THROW(FrameClock{std::numeric_limits<double>::quiet_NaN()}, std::invalid_argument);
    EXPECT_THROW(FrameClock{std::numeric_limits<double>::infinity()}, std::invalid_argument);
}

TEST(FrameClock, AVirtualClockNeverWaitsAndIsNeverLate) {
    FrameClock clock(30.0);
    for (std::uint64_t slot = 0; slot < 1000; ++slot)
        EXPECT_EQ(clock.wait(), slot);
    EXPECT_EQ(clock.overruns(), 0U);
}

/// Frames that take half their time: slot k begins at start + k / rate, to a rounding, even after an hour.
TEST(FrameClock, KeepsAnAbsoluteSchedule) {
    FakeTime time;
    FrameClock clock(60.0, time);
    for (std::uint64_t slot = 0; slot < 216000; ++slot) {
        ASSERT_EQ(clock.wait(), slot);
        ASSERT_NEAR(time.now, 100.0 + static_cast<double>(slot) / 60.0, 1e-9);
        time.now += 0.5 / 60.0;
    }
    EXPECT_EQ(clock.overruns(), 0U);
}

TEST(FrameClock, ALateFrameWithinTheNextSlotDelaysNothing) {
    FakeTime time;
    FrameClock clock(10.0, time);
    EXPECT_EQ(clock.wait(), 0U);
    time.now = 100.125; // 25 ms late for slot 1, which is still running
    EXPECT_EQ(clock.wait(), 1U);
    EXPECT_EQ(time.sleeps, 0);
    EXPECT_DOUBLE_EQ(time.now, 100.125);
    EXPECT_EQ(clock.wait(), 2U);
    EXPECT_DOUBLE_EQ(time.now, 100.2) << "the schedule did not move";
    EXPECT_EQ(clock.overruns(), 0U);
}

TEST(FrameClock, CountsTheSlotsThatWereMissedAndDoesNotCatchUp) {
    FakeTime time;
    FrameClock clock(10.0, time);
    EXPECT_EQ(clock.wait(), 0U);
    time.now = 100.45; // a frame of 450 ms: slots 1, 2, 3 are gone, 4 is running
    EXPECT_EQ(clock.wait(), 4U);
    EXPECT_EQ(clock.overruns(), 3U);
    EXPECT_EQ(clock.wait(), 5U);
    EXPECT_DOUBLE_EQ(time.now, 100.5);
    EXPECT_EQ(clock.wait(), 6U);
    EXPECT_DOUBLE_EQ(time.now, 100.6);
    EXPECT_EQ(clock.overruns(), 3U);
}

TEST(FrameClock, RestartForgivesAPause) {
    FakeTime time;
    FrameClock clock(10.0, time);
    clock.wait();
    time.now = 500.0;
    clock.restart();
    EXPECT_EQ(clock.wait(), 0U);
    EXPECT_EQ(clock.wait(), 1U);
    EXPECT_DOUBLE_EQ(time.now, 500.1);
    EXPECT_EQ(clock.overruns(), 0U);
}

TEST(SteadyTime, RunsForwards) {
    const auto time = steady_time();
    const double before = time->now_s();
    time->sleep_until(before + 0.002);
    EXPECT_GE(time->now_s(), before + 0.002 - 1e-6);
    time->sleep_until(before - 5.0);
}

TEST(SimulationCounter, FreezesStepsAndResets) {
    SimulationCounter counter;
    SignalValues running;
    SignalValues frozen;
    frozen.set(Signal::freeze, 1);
    SignalValues step = frozen;
    step.set(Signal::single_step, 1);
    SignalValues reset;
    reset.set(Signal::reset, 1);
    EXPECT_EQ(counter.next(frozen), 0U) << "the first frame is shown even when frozen";
    EXPECT_EQ(counter.next(running), 1U);
    EXPECT_EQ(counter.next(running), 2U);
    EXPECT_EQ(counter.next(frozen), 2U);
    EXPECT_EQ(counter.next(step), 3U);
    EXPECT_EQ(counter.next(frozen), 3U);
    EXPECT_EQ(counter.next(reset), 0U);
    EXPECT_EQ(counter.next(running), 1U);
    EXPECT_EQ(counter.frame(), 1U);
}

} // namespace
} // namespace linkdig::host
