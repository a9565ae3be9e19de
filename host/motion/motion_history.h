#pragma once
/// Motions from a table: linear between its rows; before the first and after the last it stands still.

#include <array>
#include <cstddef>
#include <vector>

namespace linkdig::host {

struct MotionHistory {
    static constexpr std::size_t axes = 6;
    using Values = std::array<double, axes>;
    std::vector<double> time_s; ///< ascending
    std::vector<Values> values; ///< as many

    /// All 0 if the table is empty.
    Values at(double time) const;
};

} // namespace linkdig::host
