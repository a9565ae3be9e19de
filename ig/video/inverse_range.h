#pragma once
/// Range and transmission along a line of the raster: 1/z is linear on the screen. It is taken in double at the start of each
/// 256 elements and in float from there, so that a pixel's depends on the pixel alone.

#include "ig/geometry/projected_face.h"
#include "ig/video/fog.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace linkdig::ig {

/// Elements over which 1/z runs in float.
inline constexpr std::int32_t block_elements = 256;
/// No face is nearer to infinity than this: keeps the division finite; nothing is left of the light long before.
inline constexpr float least_inverse = 1e-9F;

/// 1/z over a run inside one block, z in octaves: start + (offset + k) * along, and the elements' ray lengths.
struct InverseRange {
    float start = 0;
    float along = 0;
    std::int32_t offset = 0;
    const float* rays = nullptr;
};

inline InverseRange inverse_range(const DepthPlane& depth, const Air& air, std::int32_t line,
                                  std::int32_t element) {
    const std::int32_t block = element & ~(block_elements - 1);
    InverseRange range;
    const double inverse_m = (depth.inverse_m + line * depth.across) + block * depth.along;
    range.start = static_cast<float>(inverse_m * air.m_per_octave());
    range.along = static_cast<float>(depth.along * air.m_per_octave());
    range.offset = element - block;
    range.rays = air.rays(static_cast<std::uint32_t>(line)) + element;
    return range;
}

/// Transmission over z times a ray length. The inner loops do the same, step by step.
inline std::int32_t transmission_through(float ray, float inverse) {
    return transmission_over(std::min(ray / std::max(inverse, least_inverse), most_octaves));
}

/// Transmission of one pixel, 15 bits.
inline std::int32_t transmission_of(const DepthPlane& depth, const Air& air, std::int32_t line,
                                    std::int32_t element) {
    const InverseRange range = inverse_range(depth, air, line, element);
    return transmission_through(range.rays[0], range.start + static_cast<float>(range.offset) * range.along);
}

} // namespace linkdig::ig
