#pragma once
/// The slow painter: faces from the back to the front, pixel by pixel, each decided by exact integers, each
/// shaded by Appendix I as it is printed. It shares the snapped points with the machine and nothing else.

#include "tests/support/picture.h"

#include <cstdint>
#include <span>
#include <vector>

namespace linkdig::support {

/// Does the polygon cover the centre of (line, element)? An edge from (l0, e0) to (l1, e1) spans the centre c
/// of a line if min(l0, l1) <= c < max(l0, l1); of the edges whose crossing is at or before the pixel's
/// centre, those that lead (line descending along the polygon) count +1, those that trail -1; covered if the
/// sum is positive.
bool covers(std::span<const ig::RasterPoint> points, std::uint32_t line, std::uint32_t element);

/// Appendix I of the report, literally: along the two edges that the line cuts, then along the line between
/// them. A line or element outside the triangle (by the snapping of a clip point) continues the line; the
/// result is clamped to the range of the corners. 1.0 = 2^22.
std::int32_t gouraud(const ig::IntensityTriangle& triangle, std::uint32_t line, std::uint32_t element);

/// The picture with its intensity and rank planes. `background` is a packed pixel.
ig::VideoFrame paint(const ig::ProjectedFaces& projected, const ig::Raster& raster,
                     std::span<const Colour> colours, std::uint32_t background);

/// How many faces cover each pixel, in the layout of a picture.
std::vector<std::uint32_t> coverage(const ig::ProjectedFaces& projected, const ig::Raster& raster);

} // namespace linkdig::support
