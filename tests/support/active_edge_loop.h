#pragma once
/// The classic active-edge machine, as the hardware of the time had it (Sproull and Sutherland's and Watkins'
/// scanline processors): one line after the other, a table of the edges that the line crosses, updated by a
/// quotient and a remainder from line to line, sorted along the line; between two crossings the open face of
/// lowest rank is shown.
///
/// Coverage is its own; the intensity is the specified integer plane of ig/edges/edge.h, an input here, and
/// the pixel is rounded as ig/video/pixel_run.h specifies, so that its bytes must equal the machine's.

#include "ig/edges/edge.h"
#include "tests/support/picture.h"

#include <span>

namespace linkdig::support {

/// Intensity of a pixel of a plane: modulo 2^32, then clamped to the range of the corners.
std::int32_t plane_intensity(const ig::IntensityPlane& plane, std::int32_t line, std::int32_t element);

/// The picture with its intensity and rank planes. Of `edges` only the planes, and which face has which, are
/// read.
ig::VideoFrame active_edge_loop(const ig::ProjectedFaces& projected, const ig::FaceEdges& edges,
                                const ig::Raster& raster, std::span<const Colour> colours,
                                std::uint32_t background);

} // namespace linkdig::support
