#pragma once
/// Output of edges: for each face its crossings as a function of the line, and its intensity as a function of
/// the pixel.

#include <array>
#include <cstdint>
#include <vector>

namespace linkdig::ig {

/// Fraction bits of a crossing. With coordinates of 1/256 pixel inside the guard band two different positions
/// of a crossing against a pixel centre are at least 2^-32 pixel apart; 4096 steps of a slope rounded to
/// 2^-48 err by less than 2^-36: the crossing decides every pixel as exact rational arithmetic would.
inline constexpr int crossing_bits = 48;

/// One edge of a face over the lines whose centres it spans. The crossing of line n, already turned into
/// "first element whose centre is at or beyond it", is (start + (n - first_line) * slope) >> 48 -- modulo
/// 2^64, which is exact because the true value fits. It is a pure function of the two snapped end points and
/// the line.
struct Edge {
    std::int32_t first_line = 0; ///< first line of the raster whose centre it spans
    std::int32_t end_line = 0;   ///< one past the last
    std::int64_t start = 0;
    std::int64_t slope = 0;
};

/// Fraction bits of an outline edge's position, 1/256 pixel.
inline constexpr int outline_bits = 40;

/// One edge of a face's outline, for areas instead of centres: its position at the border above line n, in
/// 1/256 pixel, is (start + (n - first_border) * slope) >> 40. Horizontal edges bound no area and are left
/// out.
struct OutlineEdge {
    std::int32_t upper_line = 0, upper_element = 0; ///< snapped end points, 1/256 pixel
    std::int32_t lower_line = 0, lower_element = 0;
    std::int32_t first_border = 0; ///< first line whose upper border lies at or below the upper end
    std::int32_t sign = 1;         ///< 1 where the face begins, -1 where it ends
    std::int64_t start = 0;
    std::int64_t slope = 0;
};

/// Intensity of a pixel: value + (element - reference_element) * along + (line - reference_line) * across,
/// modulo 2^32, 1.0 = 2^22, then clamped to [least, greatest], the range of the face's own corners.
struct IntensityPlane {
    std::int32_t reference_line = 0;
    std::int32_t reference_element = 0;
    std::uint32_t value = 0;
    std::uint32_t along = 0;
    std::uint32_t across = 0;
    std::int32_t least = 0;
    std::int32_t greatest = 0;
};

/// A face ready for the scanline stage: leading edges first (where the face begins on a line), then trailing
/// ones. Half a cache line: a band's faces stand far apart. Lines and elements fit 16 bits (at most 4096).
struct alignas(32) EdgeFace {
    std::uint32_t first_edge = 0; ///< into FaceEdges::edges
    std::uint16_t leading = 0;
    std::uint16_t trailing = 0;
    std::int32_t first_line : 16 = 0; ///< lines it touches, within the raster
    std::int32_t end_line : 16 = 0;
    bool blends = false; ///< semi-opaque, additive or fading: others show through it
    bool additive = false;
    std::uint16_t opacity = 256; ///< of 256
    std::uint16_t fade = 256;    ///< of 256: what is seen of its level of detail
    std::uint16_t outlines = 0;
    std::int32_t level = -1;             ///< the level while it fades, else -1
    std::uint32_t first_outline = 0;     ///< into FaceEdges::outlines; with edge smoothing alone
    std::int32_t first_element : 16 = 0; ///< it touches no element outside these, within the raster
    std::int32_t end_element : 16 = 0;
};
static_assert(sizeof(EdgeFace) == 32);

/// All that video needs to know of a face in clear air, beside no other: it comes to faces in the order of the picture,
/// which is none in memory.
struct alignas(32) FaceShading {
    /// Of a flat face one that does not slope. Of a coloured one only `value` means anything: it is the place of the three
    /// planes in FaceEdges::tints.
    IntensityPlane plane;
    std::uint16_t colour = 0; ///< of the database's table, or the packet's
    bool coloured = false;
};
static_assert(sizeof(FaceShading) == 32);

/// Red, green and blue of a coloured face, 255 being 1.0.
using TintPlanes = std::array<IntensityPlane, 3>;

struct FaceEdges {
    std::vector<EdgeFace> faces;       ///< parallel to ProjectedFaces::faces
    std::vector<FaceShading> shadings; ///< parallel to those
    std::vector<Edge> edges;
    std::vector<OutlineEdge> outlines;
    std::vector<TintPlanes> tints; ///< of coloured faces
};

} // namespace linkdig::ig
