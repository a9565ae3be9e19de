#pragma once
/// How much of each pixel of a line a face covers: the exact area of its snapped outline.
///
/// Every edge adds to the pixels it crosses what it contributes to the area to its right, with the sign of its side; an
/// edge's contribution is a pure function of its snapped end points and the line, so that two faces that share the edge
/// add the same amounts with opposite signs, and neighbours of a mesh sum to exactly one pixel.

#include "ig/edges/edge.h"
#include "ig/scanline/segment.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace linkdig::ig {

/// Elements [begin, end) that the face's edges cross. Element e is covered by LineCoverage::areas[first + e - begin], of
/// whole_pixel.
struct PartlyCovered {
    std::int32_t begin = 0;
    std::int32_t end = 0;
    std::size_t first = 0;
};

/// What a face covers of one line: at most two stretches in part, and between them one wholly.
struct LineCoverage {
    std::array<PartlyCovered, 2> parts; ///< empty where begin >= end
    std::int32_t whole_begin = 0;
    std::int32_t whole_end = 0;
    std::vector<std::int32_t> areas; ///< 0 to whole_pixel; capacity persists
};

/// Coverage of a line by a convex face's outline, within [0, elements).
void cover_line(std::span<const OutlineEdge> outline, std::int32_t line, std::int32_t elements,
                LineCoverage& coverage);

} // namespace linkdig::ig
