#pragma once
/// Is every index of a visual database in range, every number finite and within its bounds, every tree a
/// tree?

#include "database/model/visual_database.h"

#include <cstdint>
#include <string>

namespace linkdig::database {

// Bounds beside those that visual_database.h states. They keep the machine's arithmetic and memory within
// limits, whatever a file says.
inline constexpr double max_coordinate_m = 1e7; ///< of any position
inline constexpr std::uint32_t max_alternatives = 65535;
inline constexpr std::uint32_t max_tree_depth =
    4096; ///< planes from a root to a leaf: trees may be walked recursively
inline constexpr std::uint32_t max_detail_levels = 16; ///< of one detail
inline constexpr double max_beam_steepness = 2e4;      ///< 1/tan^2 of a beam's half-angle of 0.4 degrees
inline constexpr double max_light_intensity = 1000;    ///< pixels at full colour code
inline constexpr double max_flash_hz = 1000;
inline constexpr std::size_t max_name_bytes = 4096;
inline constexpr double unit_tolerance = 1e-3; ///< of a unit vector's length

/// Empty: sound. Else the first thing that is wrong, and where: "faces[12].colour is 7, but there are 3
/// colours".
std::string validate(const VisualDatabase& database);

} // namespace linkdig::database
