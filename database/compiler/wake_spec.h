#pragma once
/// Wake specifications: swimmers, their paths and the field that their wakes are summed into, as a file.

#include "database/text/table_reader.h"
#include "database/water/kelvin_wake.h"

#include <optional>
#include <string>

namespace linkdig::database {

/// More samples than that are refused: at 50 million a second and core they would take minutes.
inline constexpr double most_wake_samples = 2e10;

struct WakeSpec {
    std::string title{};
    KelvinWakes wakes{}; ///< its units are metres
    std::uint32_t smoothing_passes = 0;
    double smoothing_threshold = 3.0; ///< of a pass, in root mean squares of the field before it
};

/// Mistakes go to `diagnostics`, all of the file in one go, and nothing is returned.
std::optional<WakeSpec> read_wake_spec(const std::string& path, Diagnostics& diagnostics);

struct WakeFieldResult {
    KelvinResult kelvin;
    double rms = 0.0;              ///< before smoothing
    std::uint64_t rogues = 0;      ///< before smoothing (rogue_cells)
    std::uint64_t rogues_left = 0; ///< after it
};

/// The specification's field: summed, then smoothed as often as it says.
WakeFieldResult wake_field(const WakeSpec& spec);

} // namespace linkdig::database
