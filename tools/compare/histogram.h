#pragma once
/// The histogram's levels, gathered for people.

#include "tools/compare/difference.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace linkdig::compare {

struct HistogramBar {
    std::string levels; ///< "1", "2", "3 to 4", "5 to 8" ... "beyond"
    std::uint64_t pixels = 0;
};

/// Bars that double in width; pixels that do not differ have none.
std::vector<HistogramBar> bars_of(const std::array<std::uint64_t, beyond_levels + 1>& histogram);

} // namespace linkdig::compare
