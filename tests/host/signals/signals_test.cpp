#include "host/signals/signal_store.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>
#include <thread>

namespace linkdig::host {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(SignalDirectory, NamesAreUniqueFoundAndWithinTheirBounds) {
    std::set<std::string> seen;
    for (const SignalDefinition& each : signal_directory()) {
        EXPECT_TRUE(seen.insert(each.name).second) << each.name;
        EXPECT_EQ(find_signal(each.name), each.signal);
        EXPECT_EQ(definition(each.signal).name, each.name);
        EXPECT_LT(each.minimum, each.maximum) << each.name;
        EXPECT_EQ(admissible(each.signal, each.initial), each.initial) << each.name;
    }
    EXPECT_EQ(seen.size(), signal_count);
    EXPECT_EQ(find_signal("sun_elevation"), Signal::sea_sun_elevation);
    EXPECT_EQ(find_signal("sun_rate"), Signal::sea_sun_rate);
    EXPECT_EQ(find_signal("occulting_method"), Signal::occulting);
    EXPECT_EQ(find_signal(""), std::nullopt);
    EXPECT_EQ(find_signal("Freeze"), std::nullopt);
}

TEST(SignalValues, BeginAsTheScenarioSays) {
    const SignalValues values;
    EXPECT_FALSE(values.on(Signal::freeze));
    EXPECT_TRUE(values.on(Signal::smooth_shading));
    EXPECT_EQ(values[Signal::sea_sun_elevation], 0.0);
    EXPECT_EQ(values[Signal::sea_sun_rate], 1.0);
    EXPECT_EQ(values[Signal::pitch_amplitude], 1.0);
    EXPECT_EQ(values[Signal::view], 0.0);
}

TEST(SignalValues, ClampAndRound) {
    SignalValues values;
    values.set(Signal::view, 2.4);
    EXPECT_EQ(values[Signal::view], 2.0);
    values.set(Signal::view, infinity);
    EXPECT_EQ(values[Signal::view], 3.0);
    values.set(Signal::view, -7.0);
    EXPECT_EQ(values[Signal::view], 0.0);
    values.set(Signal::pitch_amplitude, 1.25);
    EXPECT_EQ(values[Signal::pitch_amplitude], 1.25);
    values.set(Signal::pitch_amplitude, nan);
    EXPECT_EQ(values[Signal::pitch_amplitude], 1.25);
    values.set(Signal::freeze, 0.7);
    EXPECT_TRUE(values.on(Signal::freeze));
}

TEST(SignalStore, RefusesWhatIsNoNumberAndWhatIsNotInTheDirectory) {
    SignalStore store;
    EXPECT_FALSE(store.write(Signal::visibility, nan));
    EXPECT_FALSE(store.add(Signal::visibility, nan));
    EXPECT_FALSE(store.write("visibilty", 0.5));
    EXPECT_EQ(store.snapshot(), SignalValues());
    EXPECT_TRUE(store.write("visibility", 0.5));
    EXPECT_EQ(store.value(Signal::visibility), 0.5);
}

TEST(SignalStore, AddsUpToTheBound) {
    SignalStore store;
    for (int i = 0; i < 100; ++i)
        EXPECT_TRUE(store.add(Signal::pitch_amplitude, 0.25));
    EXPECT_EQ(store.value(Signal::pitch_amplitude), 2.0);
    EXPECT_TRUE(store.add(Signal::pitch_amplitude, -0.5));
    EXPECT_EQ(store.value(Signal::pitch_amplitude), 1.5);
    EXPECT_TRUE(store.add(Signal::pitch_amplitude, -infinity));
    EXPECT_EQ(store.value(Signal::pitch_amplitude), 0.0);
}

TEST(SignalStore, ASnapshotTakesPulsesAndLeavesTheRest) {
    SignalStore store;
    store.write(Signal::single_step, 1.0);
    store.change_over(Signal::freeze);
    const SignalValues first = store.snapshot();
    EXPECT_TRUE(first.on(Signal::single_step));
    EXPECT_TRUE(first.on(Signal::freeze));
    const SignalValues second = store.snapshot();
    EXPECT_FALSE(second.on(Signal::single_step));
    EXPECT_TRUE(second.on(Signal::freeze));
    EXPECT_TRUE(first.on(Signal::single_step)) << "a snapshot is a value";
    store.change_over(Signal::freeze);
    store.write(Signal::view, 3.0);
    store.restore();
    EXPECT_EQ(store.snapshot(), SignalValues());
}

TEST(SignalStore, TwoWritersLoseNothing) {
    SignalStore store;
    const auto press = [&] {
        for (int i = 0; i < 1000; ++i)
            store.add(Signal::sea_sun_elevation, 1.0 / 4096.0);
    };
    std::thread other(press);
    press();
    other.join();
    EXPECT_EQ(store.value(Signal::sea_sun_elevation), 2000.0 / 4096.0);
}

} // namespace
} // namespace linkdig::host
