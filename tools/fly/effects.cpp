#include "tools/fly/effects.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace linkdig::tools {
namespace {

using host::HostLoop;
using host::Occulting;
using host::Signal;
using host::SignalValues;
using host::Wake;

constexpr std::array names{
    "smooth shading",    "haze",           "ship motion", "turned normals", "box",
    "fitted box",        "wedges",         "white v",     "blended v",      "cam",
    "face substitution", "solid bow wake", "churned",     "kelvin wake",    "wave particles"};
static_assert(names.size() == effect_count);

constexpr double hazy = 0.1;

std::optional<Occulting> occulting_of(Effect effect) {
    if (effect == Effect::box) return Occulting::box;
    if (effect == Effect::fitted_box) return Occulting::fitted_box;
    if (effect == Effect::wedges) return Occulting::wedges;
    return std::nullopt;
}

std::optional<Wake> wake_of(Effect effect) {
    if (effect < Effect::white_v) return std::nullopt;
    return static_cast<Wake>(static_cast<int>(effect) - static_cast<int>(Effect::white_v));
}

Signal signal_of(Wake wake) {
    if (wake == Wake::kelvin) return Signal::kelvin;
    if (wake == Wake::wave_particles) return Signal::wave_particles;
    return static_cast<Signal>(static_cast<int>(Signal::white_v) + static_cast<int>(wake));
}

struct Cost {
    double host_s = 1e9;
    double ig_s = 1e9;
    std::int64_t edges = 0;
};

Cost cost_of(Flight& flight, std::uint64_t frame, const SignalValues& signals) {
    constexpr int tries = 3;
    Cost cost;
    const ig::History history = flight.machine().history();
    for (int i = 0; i < tries; ++i) {
        flight.machine().restore(history);
        const FrameReport& report = flight.draw(frame, signals);
        cost.host_s = std::min(cost.host_s, flight.costs().last_host_s);
        cost.ig_s = std::min(cost.ig_s, flight.costs().last_machine_s);
        cost.edges = 0;
        for (const ChannelReport& channel : report.channels)
            cost.edges += static_cast<std::int64_t>(channel.edges);
    }
    return cost;
}

} // namespace

const char* effect_name(Effect effect) { return names[static_cast<std::size_t>(effect)]; }

bool is_possible(Effect effect, const HostLoop& loop) {
    const auto some = [&](auto method) {
        return std::ranges::any_of(loop.ship_methods(), [&](const auto& ship) { return ship.can(method); });
    };
    if (const auto method = occulting_of(effect)) return some(*method);
    if (const auto wake = wake_of(effect)) return some(*wake);
    if (effect == Effect::turned_normals) return loop.can_turn_normals();
    return effect != Effect::ship_motion || !loop.ship_methods().empty();
}

bool is_on(Effect effect, const SignalValues& signals, const HostLoop& loop) {
    const auto some = [&](const auto& shown) { return std::ranges::any_of(loop.ship_methods(), shown); };
    if (const auto method = occulting_of(effect))
        return some([&](const auto& ship) { return ship.occulting(signals) == *method; });
    if (const auto wake = wake_of(effect))
        return some([&](const auto& ship) { return ship.shows(*wake, signals); });
    switch (effect) {
    case Effect::smooth_shading:
        return signals.on(Signal::smooth_shading);
    case Effect::haze:
        return signals[Signal::visibility] < 1.0;
    case Effect::ship_motion:
        return signals[Signal::ship_motion] > 0.0;
    default:
        return loop.sea_method(signals) == host::SeaMethod::normals;
    }
}

SignalValues switched(Effect effect, bool on, const SignalValues& signals, const HostLoop& loop) {
    SignalValues changed = signals;
    if (on == is_on(effect, signals, loop)) return changed;
    const auto change_over = [&](Signal signal) { changed.set(signal, signals.on(signal) ? 0.0 : 1.0); };
    if (const auto method = occulting_of(effect)) {
        const Occulting wanted = on ? *method : Occulting::waterline;
        changed.set(Signal::occulting, static_cast<double>(wanted) + 1.0);
    } else if (const auto wake = wake_of(effect)) {
        change_over(signal_of(*wake));
    } else if (effect == Effect::smooth_shading) {
        change_over(Signal::smooth_shading);
    } else if (effect == Effect::haze) {
        changed.set(Signal::visibility, on ? hazy : 1.0);
    } else if (effect == Effect::ship_motion) {
        changed.set(Signal::ship_motion, on ? 1.0 : 0.0);
    } else {
        change_over(Signal::sea_method);
    }
    return changed;
}

Price price_of(Effect effect, Flight& flight, std::uint64_t frame, const SignalValues& signals) {
    const HostLoop& loop = flight.loop();
    const bool on = is_on(effect, signals, loop);
    const ig::History history = flight.machine().history();
    const Cost other = cost_of(flight, frame, switched(effect, !on, signals, loop));
    flight.machine().restore(history);
    const Cost now = cost_of(flight, frame, signals);
    const Cost& with = on ? now : other;
    const Cost& without = on ? other : now;
    return {.edges = with.edges - without.edges,
            .host_ms = 1000.0 * (with.host_s - without.host_s),
            .ig_ms = 1000.0 * (with.ig_s - without.ig_s)};
}

std::string effect_line(Effect effect, const SignalValues& signals, const HostLoop& loop,
                        const std::optional<Price>& price) {
    const char* state = !is_possible(effect, loop) ? "--" : is_on(effect, signals, loop) ? "on" : "off";
    std::string line = fmt::format("{:<17} {:<3}", effect_name(effect), state);
    if (price)
        line += fmt::format(" {:+6} edges  host {:+.2f} ms  ig {:+.2f} ms", price->edges, price->host_ms,
                            price->ig_ms);
    return line;
}

} // namespace linkdig::tools
