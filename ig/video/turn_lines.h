#pragma once
/// Lines become columns: a vertical scan's elements lie one below the other in the picture.

#include <cstddef>
#include <cstdint>

namespace linkdig::ig {

/// Pixels of lines one behind the other, and the picture that they go into as columns.
struct LinesToTurn {
    const std::uint32_t* pixels = nullptr; ///< the first line's first element
    std::size_t length = 0;                ///< from line to line
    std::size_t lines = 0;
    std::size_t elements = 0;         ///< of each line that are wanted, at most its length
    std::uint32_t* picture = nullptr; ///< the first line's column, first row
    std::size_t width = 0;            ///< from row to row
};

void turn_lines(const LinesToTurn& turned);

} // namespace linkdig::ig
