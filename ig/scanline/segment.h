#pragma once
/// Output of scanline: the visible runs of a band of lines. Every element belongs to exactly one segment or
/// to the background.

#include <cstdint>
#include <vector>

namespace linkdig::ig {

/// Lines that are resolved together.
inline constexpr std::uint32_t band_lines = 32;

/// Elements [first, first + count) of a line show the face of this rank.
struct Segment {
    std::uint32_t face = 0; ///< rank: into ProjectedFaces::faces
    std::uint16_t line = 0;
    std::uint16_t first = 0;
    std::uint16_t count = 0;
};

/// One band's segments in the order in which they were resolved: by rank, then line, then element.
struct BandSegments {
    std::uint32_t first_line = 0;
    std::uint32_t end_line = 0;
    std::vector<Segment> segments;
    std::vector<Segment> background; ///< what no face covers; `face` is meaningless
};

} // namespace linkdig::ig
