#pragma once
/// Stage 4, edges: crossings and intensity planes in fixed point. From here on there are only integers.

#include "ig/configuration.h"
#include "ig/edges/edge.h"
#include "ig/geometry/projected_face.h"

namespace linkdig::ig {

/// With smoothing the faces' outlines are made, too, and their lines are those that they touch at all.
void make_edges(const ProjectedFaces& projected, const Raster& raster, bool smoothing, FaceEdges& edges);

/// Adds the edges of the next part of the faces behind what is there.
void append(const FaceEdges& part, FaceEdges& all);

/// The three planes of a coloured face.
inline const TintPlanes& tint_of(const FaceEdges& edges, const FaceShading& coloured) {
    return edges.tints[coloured.plane.value];
}

/// First element whose centre is at or beyond the edge's crossing of `line`; may lie outside the raster.
inline std::int32_t first_element(const Edge& edge, std::int32_t line) {
    const auto steps = static_cast<std::uint64_t>(line - edge.first_line);
    const std::uint64_t crossing =
        static_cast<std::uint64_t>(edge.start) + steps * static_cast<std::uint64_t>(edge.slope);
    return static_cast<std::int32_t>(static_cast<std::int64_t>(crossing) >> crossing_bits);
}

/// A plane's value at a pixel before it is clamped, modulo 2^32.
inline std::uint32_t value_at(const IntensityPlane& plane, std::int32_t line, std::int32_t element) {
    return plane.value + static_cast<std::uint32_t>(element - plane.reference_element) * plane.along +
           static_cast<std::uint32_t>(line - plane.reference_line) * plane.across;
}

/// Intensity of a pixel, 1.0 = 2^22.
inline std::int32_t intensity_at(const IntensityPlane& plane, std::int32_t line, std::int32_t element) {
    const auto intensity = static_cast<std::int32_t>(value_at(plane, line, element));
    return intensity < plane.least ? plane.least : intensity > plane.greatest ? plane.greatest : intensity;
}

} // namespace linkdig::ig
