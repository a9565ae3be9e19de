#pragma once
/// What the air before a face lets through of its light: nearly a plane over the screen where the range changes little over the
/// face, as most do that are far or small. It is then shaded like an intensity, with nothing to be taken pixel by pixel.

#include "ig/edges/edges.h"
#include "ig/geometry/projected_face.h"
#include "ig/video/fog.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace linkdig::ig {

enum class AirKind : std::uint32_t {
    clear,    ///< none: what stands at the eye
    plane,    ///< the transmission is a plane
    by_pixel, ///< it is taken along the runs (air_samples.h)
};

/// Of the air before one face.
struct alignas(32) FaceAir {
    IntensityPlane transmission; ///< AirKind::plane: 1.0 = 2^22, as an intensity
    AirKind kind = AirKind::clear;
};

/// A third of a level: what a plane of transmission may be off.
inline constexpr double planar_error = 1.0 / 765.0;

/// The air before each face; parallel to them. Nothing where the air is clear.
void judge_air(const ProjectedFaces& projected, const FaceEdges& edges, const Air& air,
               std::vector<FaceAir>& face_air);

/// Of one pixel, 15 bits.
inline std::int32_t planar_transmission(const IntensityPlane& transmission, std::int32_t line,
                                        std::int32_t element) {
    return std::min(intensity_at(transmission, line, element) >> 7, transmission_one);
}

/// 15 bits, of one pixel of a face, as video takes it where it takes it pixel by pixel. Not of AirKind::clear.
std::int32_t transmission_of(const FaceAir& face_air, const DepthPlane& depth, const Air& air,
                             std::int32_t line, std::int32_t element);

} // namespace linkdig::ig
