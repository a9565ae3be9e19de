#pragma once
/// The shedding order of light points: at light step k every 2^k-th light point of the data base is there. Strings grow
/// thin, and none goes dark.

#include <algorithm>
#include <bit>
#include <cstdint>

namespace linkdig::ig {

inline constexpr std::uint32_t light_steps = 8;

/// The last light step that still lets the light point at this place of the data base through.
inline std::uint32_t last_step_of_light(std::uint32_t light) {
    return std::min(light_steps, static_cast<std::uint32_t>(std::countr_zero(light)));
}

} // namespace linkdig::ig
