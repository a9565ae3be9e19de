#include "tools/fly/controls.h"

#include <array>
#include <cstddef>

namespace linkdig::tools {
namespace {

using host::Signal;
using host::SignalStore;

void step(SignalStore& signals) {
    if (signals.value(Signal::freeze) != 0.0) signals.write(Signal::single_step, 1.0);
    signals.write(Signal::freeze, 1.0);
}

void reset(SignalStore& signals) {
    const double frozen = signals.value(Signal::freeze);
    signals.restore();
    signals.write(Signal::freeze, frozen);
    signals.write(Signal::reset, 1.0);
}

void change_sea_rate(double by, const host::HostLoop& loop, std::uint64_t frame, SignalStore& signals) {
    const double rate = signals.value(Signal::sea_sun_rate) + by;
    const host::SignalValues changed = loop.with_sea_sun_rate(standing(signals), rate, frame);
    signals.write(Signal::sea_sun_rate, changed[Signal::sea_sun_rate]);
    signals.write(Signal::sea_sun_azimuth, changed[Signal::sea_sun_azimuth]);
}

} // namespace

void apply(Action action, const host::HostLoop& loop, std::uint64_t frame, SignalStore& signals,
           Screen& screen) {
    switch (action) {
    case Action::pause:
        signals.change_over(Signal::freeze);
        break;
    case Action::step:
        step(signals);
        break;
    case Action::sun_up:
        signals.add(Signal::sea_sun_elevation, sun_step_rad);
        break;
    case Action::sun_down:
        signals.add(Signal::sea_sun_elevation, -sun_step_rad);
        break;
    case Action::sea_sun_slower:
        change_sea_rate(-sea_rate_step, loop, frame, signals);
        break;
    case Action::sea_sun_faster:
        change_sea_rate(sea_rate_step, loop, frame, signals);
        break;
    case Action::earlier:
        signals.add(Signal::time_of_day, -hour_step);
        break;
    case Action::later:
        signals.add(Signal::time_of_day, hour_step);
        break;
    case Action::smooth_shading:
        signals.change_over(Signal::smooth_shading);
        break;
    case Action::view_ahead:
        signals.write(Signal::view, 0.0);
        break;
    case Action::view_left:
        signals.write(Signal::view, 1.0);
        break;
    case Action::view_right:
        signals.write(Signal::view, 2.0);
        break;
    case Action::view_down:
        signals.write(Signal::view, 3.0);
        break;
    case Action::reset:
        reset(signals);
        break;
    case Action::help:
        screen.help = !screen.help;
        break;
    case Action::quit:
        screen.quit = true;
        break;
    }
}

host::SignalValues standing(const SignalStore& signals) {
    host::SignalValues values;
    for (const host::SignalDefinition& each : host::signal_directory())
        if (each.kind != host::SignalKind::pulse) values.set(each.signal, signals.value(each.signal));
    return values;
}

const char* view_name(const host::SignalValues& signals) {
    constexpr std::array names{"ahead", "left", "right", "down"};
    return names[static_cast<std::size_t>(signals[Signal::view])];
}

} // namespace linkdig::tools
