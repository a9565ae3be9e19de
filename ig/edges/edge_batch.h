#pragma once
/// Edges and intensity planes of faces with three or four corners, many at a time. Every level of SIMD gives the bits of the
/// plain way (ig/edges/edges.cpp): single IEEE 754 operations in the same order, and whole numbers.

#include "ig/edges/edge.h"
#include "ig/geometry/projected_face.h"

#include <cstddef>
#include <cstdint>

namespace linkdig::ig {

/// Fraction bits that a quotient of raster coordinates, which are in 1/256 pixel already, is given.
inline constexpr int fraction_bits = crossing_bits - 8;

/// A crossing exactly on a pixel centre belongs to that pixel: the quotients are rounded down by less than 2^-36 pixel,
/// different positions differ by at least 2^-32, so one minus this turns "floor" into an exact "ceiling".
inline constexpr std::int64_t tie = std::int64_t{1} << (crossing_bits - 34);

/// From a crossing to its Edge::start.
inline constexpr std::int64_t crossing_to_start = (std::int64_t{1} << (crossing_bits - 1)) - tie;

/// Values of an intensity plane are held inside +-2^62 (1.0 = 2^22). Beyond it only slivers of no width arrive; their pixels
/// are clamped to the corners' range.
inline constexpr double plane_bound = 4611686018427387904.0;

/// Do others show through it?
inline bool blends(const ProjectedFace& face) {
    return face.added_to >= 0 || face.opacity < opaque || face.fade < opaque;
}

/// Room for `more` edges behind those that are made.
inline Edge* room_for_edges(FaceEdges& out, std::size_t edges_made, std::size_t more) {
    if (out.edges.size() < edges_made + more) out.edges.resize(edges_made + more);
    return out.edges.data() + edges_made;
}

/// Makes the edges and shadings of faces from `rank` on, without smoothing, until one comes that has more corners or is
/// coloured. Places in `out.faces` and `out.shadings` are there; edges are put behind the `edges_made` first. Returns how many
/// faces it has dealt with: none where SIMD is switched off.
std::size_t make_edges_together(const ProjectedFaces& projected, std::size_t rank, std::int32_t lines,
                                std::int32_t elements, FaceEdges& out, std::size_t& edges_made);

} // namespace linkdig::ig
