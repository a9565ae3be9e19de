#pragma once
/// From keys to named signals.

#include "host/loop/host_loop.h"
#include "host/signals/signal_store.h"
#include "tools/fly/effects.h"
#include "tools/fly/keys.h"

#include <cstdint>

namespace linkdig::tools {

/// What keys set that is no affair of the host's.
struct Screen {
    bool help = true;
    bool all_keys = false;
    bool panel = false;      ///< figures and effects
    bool of_1980 = false;    ///< the picture of the ames profile
    bool save_state = false; ///< asked for; whoever does it takes the mark away, as with the two below
    bool load_state = false;
    bool switch_effect = false;
    std::size_t effect = 0; ///< the chosen one
    bool quit = false;
};

/// One press of a key raises or lowers the sea's sun by this much.
inline constexpr double sun_step_rad = radians(2.0);
/// One press of a key changes the ships' speed by this part of the scenario's.
inline constexpr double ship_speed_step = 0.1;
/// One press of a key moves the time of day by this much.
inline constexpr double hour_step = 0.5;
/// One press of a key adds this part of the scenario's rate to the sea's sun: four presses to the left stop
/// it.
inline constexpr double sea_rate_step = 0.25;
/// The same for Figure 7's other increment.
inline constexpr double elevation_rate_step_rad_s = radians(1.0);

/// Writes what the action means. A single step freezes first; a reset puts every signal back but leaves a frozen flight
/// frozen and a recorded one recorded.
void apply(Action action, const host::HostLoop& loop, host::SignalStore& signals, Screen& screen);

/// The signals as they stand, without taking the pulses.
host::SignalValues standing(const host::SignalStore& signals);
/// The values with no pulse among them.
host::SignalValues without_pulses(const host::SignalValues& values);

/// The next occulting method that some ship of the flight can show, as the signal's value; after the last the scenario's own.
double next_occulting(const host::HostLoop& loop, double now);

/// "ahead", "left", "right" or "down".
const char* view_name(const host::SignalValues& signals);

} // namespace linkdig::tools
