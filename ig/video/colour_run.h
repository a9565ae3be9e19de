#pragma once
/// Consecutive pixels of a face whose corners have colours: three interpolants instead of one. Plain integers, the same
/// everywhere; the compiler makes vectors of them.

#include "ig/video/pixel_run.h"

#include <array>
#include <cstdint>

namespace linkdig::ig {

/// Intensities of red, green and blue (1.0 = 2^22), 255 being 1.0.
using Tint = std::array<std::int32_t, 3>;

/// Of a pixel, from the face's three planes.
Tint tint_at(const IntensityPlane* planes, std::int32_t line, std::int32_t element);

/// Before it is rounded to levels, as lit().
Components lit(const Tint& tint);

/// The pixel, as shade().
std::uint32_t shade(const Tint& tint);

/// Shades `count` pixels of a line from `element` on, in clear air.
void colour_run(const IntensityPlane* planes, std::int32_t line, std::int32_t element, std::uint32_t count,
                std::uint32_t* pixels);

/// Through the air before the face, of these planes and this depth.
void colour_run_in_air(const IntensityPlane* planes, const FaceAir& face_air, const DepthPlane& depth,
                       const Air& air, std::int32_t line, std::int32_t element, std::uint32_t count,
                       std::uint32_t* pixels);

} // namespace linkdig::ig
