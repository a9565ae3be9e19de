#pragma once
/// How much of each pixel of a line a face covers: the exact area of its snapped outline.
///
/// Every edge adds to the pixels it crosses what it contributes to the area to its right, with the sign of its side; an
/// edge's contribution is a pure function of its snapped end points and the line, so that two faces that share the edge
/// add the same amounts with opposite signs, and neighbours of a mesh sum to exactly one pixel.

#include "ig/edges/edge.h"
#include "ig/scanline/segment.h"

#include <cstdint>
#include <span>
#include <vector>

namespace linkdig::ig {

/// What the edges contribute to one pixel: `cover` is the height of the edges inside it (of 256), `area` the part of it
/// that lies to their left, in units of whole_pixel.
struct CoverageCell {
    std::int32_t element = 0;
    std::int32_t cover = 0;
    std::int32_t area = 0;
};

/// Elements [begin, end) are covered by the same amount, 1 to whole_pixel.
struct CoverageRun {
    std::int32_t begin = 0;
    std::int32_t end = 0;
    std::uint32_t coverage = 0;
};

/// Coverage of a line by a face's outline, as runs from left to right within [0, elements). `cells` is working storage.
void cover_line(std::span<const OutlineEdge> outline, std::int32_t line, std::int32_t elements,
                std::vector<CoverageCell>& cells, std::vector<CoverageRun>& runs);

} // namespace linkdig::ig
