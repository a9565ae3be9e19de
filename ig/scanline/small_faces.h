#pragma once
/// Small opaque faces, several lines at once: the scanline stage where vectors serve it. What it does with a face is what
/// BandResolver (ig/scanline/scanline.cpp) does line by line, and the same to the bit.
///
/// A face is small if on each line its elements lie in a window of 64 that begins at a byte of the mask.

#include "ig/edges/edge.h"
#include "ig/scanline/segment.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace linkdig::ig {

/// Lines behind a band's last that a vector which begins on that one reaches over.
inline constexpr std::size_t lines_behind = 8;

/// What is still open of a band of lines.
struct OpenBand {
    std::int32_t first_line = 0;
    std::int32_t end_line = 0;
    std::int32_t elements = 0;
    std::size_t stride = 0; ///< words of 64 elements from line to line, one of them spare
    /// A bit per element, band_lines + lines_behind lines whatever the band has: 1 = something is left.
    std::vector<std::uint64_t> open;
    alignas(64)
        std::array<std::uint64_t, band_lines + lines_behind> count{}; ///< elements still open on each line
    std::uint32_t open_lines = 0;                                     ///< lines with an open element
};

/// Takes for each face of these ranks, front to back, what is open between its crossings, until a face comes that is not
/// small or that blends, or nothing is open. Returns how many faces it has dealt with: none on a machine without vectors.
std::size_t take_small_faces(const FaceEdges& edges, std::span<const std::uint32_t> ranks, OpenBand& band,
                             SegmentList& segments);

} // namespace linkdig::ig
