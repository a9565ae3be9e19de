#include "tools/fly/controls.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <initializer_list>

namespace linkdig::tools {
namespace {

using host::Signal;
using host::SignalStore;

void step(SignalStore& signals) {
    if (signals.value(Signal::freeze) != 0.0) signals.write(Signal::single_step, 1.0);
    signals.write(Signal::freeze, 1.0);
}

void reset(SignalStore& signals) {
    host::SignalValues first;
    for (const Signal kept : {Signal::freeze, Signal::record})
        first.set(kept, signals.value(kept));
    signals.assign(first);
    signals.write(Signal::reset, 1.0);
}

/// The value after `now`, and after the last the first again.
double after(double now, std::initializer_list<double> values) {
    const auto found = std::find(values.begin(), values.end(), now);
    return found == values.end() || found + 1 == values.end() ? *values.begin() : *(found + 1);
}

void go_on(Signal signal, std::initializer_list<double> values, SignalStore& signals) {
    signals.write(signal, after(signals.value(signal), values));
}

/// Actions that write one signal.
bool write_signal(Action action, SignalStore& signals) {
    switch (action) {
    case Action::pause:
        signals.change_over(Signal::freeze);
        return true;
    case Action::step:
        step(signals);
        return true;
    case Action::sun_up:
        return signals.add(Signal::sea_sun_elevation, sun_step_rad);
    case Action::sun_down:
        return signals.add(Signal::sea_sun_elevation, -sun_step_rad);
    case Action::sea_sun_slower:
        return signals.add(Signal::sea_sun_rate, -sea_rate_step);
    case Action::sea_sun_faster:
        return signals.add(Signal::sea_sun_rate, sea_rate_step);
    case Action::earlier:
        return signals.add(Signal::time_of_day, -hour_step);
    case Action::later:
        return signals.add(Signal::time_of_day, hour_step);
    case Action::elevation_rate_down:
        return signals.add(Signal::sea_sun_elevation_rate, -elevation_rate_step_rad_s);
    case Action::elevation_rate_up:
        return signals.add(Signal::sea_sun_elevation_rate, elevation_rate_step_rad_s);
    case Action::ship_slower:
        return signals.add(Signal::ship_speed, -ship_speed_step);
    case Action::ship_faster:
        return signals.add(Signal::ship_speed, ship_speed_step);
    case Action::record:
        signals.change_over(Signal::record);
        return true;
    case Action::view_ahead:
    case Action::view_left:
    case Action::view_right:
    case Action::view_down:
        return signals.write(Signal::view,
                             static_cast<double>(action) - static_cast<double>(Action::view_ahead));
    case Action::reset:
        reset(signals);
        return true;
    default:
        return false;
    }
}

/// Actions that choose among methods.
bool choose_method(Action action, const host::HostLoop& loop, SignalStore& signals) {
    switch (action) {
    case Action::next_channel: {
        const std::size_t next = static_cast<std::size_t>(signals.value(Signal::channel_select)) + 1;
        return signals.write(Signal::channel_select,
                             next < loop.channels() ? static_cast<double>(next) : 0.0);
    }
    case Action::smooth_shading:
        signals.change_over(Signal::smooth_shading);
        return true;
    case Action::sea_state:
        go_on(Signal::sea_state, {0.0, 1.0, 2.0, 3.0}, signals);
        return true;
    case Action::sea_method:
        signals.change_over(Signal::sea_method);
        return true;
    case Action::normals_every:
        go_on(Signal::normals_every, {0.0, 2.0, 4.0, 8.0}, signals);
        return true;
    case Action::occulting:
        return signals.write(Signal::occulting, next_occulting(loop, signals.value(Signal::occulting)));
    case Action::white_v:
    case Action::blended_v:
    case Action::cam:
    case Action::face_substitution:
    case Action::solid:
    case Action::churned:
        signals.change_over(static_cast<Signal>(static_cast<int>(Signal::white_v) + static_cast<int>(action) -
                                                static_cast<int>(Action::white_v)));
        return true;
    case Action::pitch_amplitude:
        go_on(Signal::pitch_amplitude, {1.0, 2.0}, signals);
        return true;
    case Action::ship_motion:
        go_on(Signal::ship_motion, {1.0, 0.0}, signals);
        return true;
    case Action::visibility:
        go_on(Signal::visibility, {1.0, 0.3, 0.1, 0.03}, signals);
        return true;
    case Action::hands_on:
        signals.change_over(Signal::hands_on);
        return true;
    default:
        return false;
    }
}

void change_screen(Action action, Screen& screen) {
    switch (action) {
    case Action::help:
        screen.help = !screen.help;
        break;
    case Action::all_keys:
        screen.all_keys = !screen.all_keys;
        break;
    case Action::panel:
        screen.panel = !screen.panel;
        break;
    case Action::profile:
        screen.of_1980 = !screen.of_1980;
        break;
    case Action::save_state:
        screen.save_state = true;
        break;
    case Action::load_state:
        screen.load_state = true;
        break;
    case Action::next_effect:
        screen.panel = true;
        screen.effect = (screen.effect + 1) % effect_count;
        break;
    case Action::switch_effect:
        screen.switch_effect = true;
        break;
    case Action::quit:
        screen.quit = true;
        break;
    default:
        break;
    }
}

} // namespace

void apply(Action action, const host::HostLoop& loop, host::SignalStore& signals, Screen& screen) {
    if (write_signal(action, signals) || choose_method(action, loop, signals)) return;
    change_screen(action, screen);
}

double next_occulting(const host::HostLoop& loop, double now) {
    for (std::size_t next = static_cast<std::size_t>(now) + 1; next <= host::occulting_names.size(); ++next) {
        const auto method = static_cast<host::Occulting>(next - 1);
        for (const host::ShipMethods& ship : loop.ship_methods())
            if (ship.can(method)) return static_cast<double>(next);
    }
    return 0.0;
}

host::SignalValues standing(const SignalStore& signals) {
    host::SignalValues values;
    for (const host::SignalDefinition& each : host::signal_directory())
        if (each.kind != host::SignalKind::pulse) values.set(each.signal, signals.value(each.signal));
    return values;
}

host::SignalValues without_pulses(const host::SignalValues& values) {
    host::SignalValues kept = values;
    for (const host::SignalDefinition& each : host::signal_directory())
        if (each.kind == host::SignalKind::pulse) kept.set(each.signal, 0.0);
    return kept;
}

const char* view_name(const host::SignalValues& signals) {
    constexpr std::array names{"ahead", "left", "right", "down"};
    return names[static_cast<std::size_t>(signals[Signal::view])];
}

} // namespace linkdig::tools
