#pragma once
/// Consecutive pixels of one smooth-shaded face: the machine's inner loop, once for every SIMD level.
///
/// Only integers, so every level gives the same bytes: SSE2 to AVX-512 are chosen at run time, plain C++ is
/// always there.

#include "database/model/visual_database.h"
#include "ig/edges/edge.h"

#include <cstdint>
#include <string>
#include <vector>

namespace linkdig::ig {

/// A colour code at an intensity (1.0 = 2^22): each component x intensity, rounded once to the nearest level.
/// The intensity takes part with 15 bits, which moves the product by less than 1/128 level.
inline std::uint32_t shade(Colour colour, std::int32_t intensity) {
    const std::uint32_t i = static_cast<std::uint32_t>(intensity) >> 7U;
    const std::uint32_t scale = i > 32767U ? 32767U : i;
    constexpr std::uint32_t half = 1U << 14U;
    return ((colour.red * scale + half) >> 15U) | ((colour.green * scale + half) >> 15U) << 8U |
           ((colour.blue * scale + half) >> 15U) << 16U | 0xff000000U;
}

/// Shades `count` pixels of a line from `element` on.
void shade_run(const IntensityPlane& plane, Colour colour, std::int32_t line, std::int32_t element,
               std::uint32_t count, std::uint32_t* pixels);

/// SIMD levels of this build that the machine has, best first; the last is always "scalar".
std::vector<std::string> simd_levels();

/// Uses this level from now on ("" or "best": the best there is). False if the machine lacks it; then nothing
/// changes.
bool use_simd_level(const std::string& level);

} // namespace linkdig::ig
