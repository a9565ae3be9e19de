#pragma once
/// How much of each pixel of a line a face covers: the exact area of its snapped outline.
///
/// Every edge adds to the pixels it crosses what it contributes to the area to its right, with the sign of its side; an
/// edge's contribution is a pure function of its snapped end points and the line, so that two faces that share the edge
/// add the same amounts with opposite signs, and neighbours of a mesh sum to exactly one pixel.

#include "ig/edges/edge.h"
#include "ig/scanline/segment.h"

#include <algorithm>
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

/// The part of an edge inside one line, from `left` to `right`, 1/256 pixel along the line; `rise` is how far it gets
/// across the line (1/256, signed) and `height` the same without sign.
struct EdgePiece {
    std::int32_t left = 0;
    std::int32_t right = 0;
    std::int32_t rise = 0;
    std::int32_t height = 0;
    std::int32_t sign = 1; ///< OutlineEdge::sign

    std::int32_t first() const { return left >> 8; }
    std::int32_t last() const { return right >> 8; }
};

/// The elements that the edges of one side cross, and the height of the line that they span together.
struct EdgeSide {
    std::int32_t begin = INT32_MAX;
    std::int32_t end = INT32_MIN;
    std::int32_t height = 0;

    void add(const EdgePiece& piece) {
        begin = std::min(begin, piece.first());
        end = std::max(end, piece.last() + 1);
        height += piece.height;
    }
};

/// Where a face's outline runs on one line.
struct OutlineLine {
    std::vector<EdgePiece> pieces; ///< capacity persists
    EdgeSide leading, trailing;
    std::int32_t begin = 0; ///< elements that the face touches lie in [begin, end), within the raster
    std::int32_t end = 0;
};

/// What a face covers of one line: at most two stretches in part, and between them one wholly.
struct LineCoverage {
    std::array<PartlyCovered, 2> parts; ///< empty where begin >= end
    std::int32_t whole_begin = 0;
    std::int32_t whole_end = 0;
    std::vector<std::int32_t> areas; ///< 0 to whole_pixel; capacity persists
};

/// Finds a convex face's outline on a line; begin >= end where it touches none of the elements [0, elements).
void trace_line(std::span<const OutlineEdge> outline, std::int32_t line, std::int32_t elements,
                OutlineLine& traced);

/// Coverage of the line.
void cover_line(const OutlineLine& traced, std::int32_t elements, LineCoverage& coverage);

} // namespace linkdig::ig
