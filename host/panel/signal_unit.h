#pragma once
/// The units in which people write a signal's values, and in which displays show them.

#include "host/panel/mapping.h"

#include <array>
#include <string_view>

namespace linkdig::panel {

struct SignalUnit {
    std::string_view ending; ///< of a key: "step_deg"
    double in_si = 1.0;      ///< one of it, in the signal's own unit
};

inline constexpr std::array unit_endings{"", "_deg", "_deg_s", "_h", "_s"};

SignalUnit unit_of(host::Signal signal);
/// Indications are in the unit that their names or descriptions say already.
SignalUnit unit_of(const Shown& shown);

/// "shows" as the file names it.
const char* name_of(const Shown& shown);

} // namespace linkdig::panel
