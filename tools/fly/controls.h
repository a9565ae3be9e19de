#pragma once
/// From keys to named signals.

#include "host/loop/host_loop.h"
#include "host/signals/signal_store.h"
#include "tools/fly/keys.h"

#include <cstdint>

namespace linkdig::tools {

/// What keys set that is no affair of the host's.
struct Screen {
    bool help = true;
    bool quit = false;
};

/// One press of a key raises or lowers the sea's sun by this much.
inline constexpr double sun_step_rad = radians(2.0);
/// One press of a key moves the time of day by this much.
inline constexpr double hour_step = 0.5;
/// One press of a key adds this part of the scenario's rate to the sea's sun: four presses to the left stop
/// it.
inline constexpr double sea_rate_step = 0.25;

/// Writes what the action means. `frame` is the one on the screen: the sea changes its pace from there on,
/// without a jump. A single step freezes first; a reset puts every signal back but leaves a frozen flight
/// frozen.
void apply(Action action, const host::HostLoop& loop, std::uint64_t frame, host::SignalStore& signals,
           Screen& screen);

/// The signals as they stand, without taking the pulses.
host::SignalValues standing(const host::SignalStore& signals);

/// "ahead", "left", "right" or "down".
const char* view_name(const host::SignalValues& signals);

} // namespace linkdig::tools
