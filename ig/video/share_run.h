#pragma once
/// Consecutive shares of one face: its colour, times a weight per pixel, added to sums. The inner loop of smoothed edges and of
/// light that is added, once for every SIMD level (ig/video/pixel_run.h chooses it); only integers, the same sums from each.

#include "ig/video/pixel_run.h"

#include <cstdint>

namespace linkdig::ig {

/// The most of a component, 7 fraction bits.
inline constexpr std::uint32_t brightest = 255U << 7U;

/// What a run's pixels are coloured with.
struct RunColour {
    Colour colour;
    IntensityPlane plane;
    std::int32_t transmission = -1; ///< of the air before it, the same for all its pixels; -1: clear
    Colour horizon;
};

/// Sums of consecutive pixels: components with 7 fraction bits, x weights where nothing else is said. sums_padding more of each can be
/// written, and are left as they are.
struct SumsAt {
    std::uint32_t* red = nullptr;
    std::uint32_t* green = nullptr;
    std::uint32_t* blue = nullptr;
};
inline constexpr std::size_t sums_padding = 16;

/// Where a run lies: `count` pixels of a line from `element` on, each with its weight, of whole_pixel. weights_padding more
/// weights can be read.
struct RunPlace {
    std::int32_t line = 0;
    std::int32_t element = 0;
    std::uint32_t count = 0;
    const std::uint32_t* weights = nullptr;
};

/// Adds colour x weight to the sums.
void add_share_run(const RunColour& run, const RunPlace& place, const SumsAt& sums);

/// The same of a face that `light`, components of its pixels, brightens first: both together are clamped once.
void add_lit_run(const RunColour& run, const RunPlace& place, const SumsAt& light, const SumsAt& sums);

/// Adds the run's own part, colour x weight / whole_pixel, to `light`, which waits for the face behind it.
void add_light_run(const RunColour& run, const RunPlace& place, const SumsAt& light);

} // namespace linkdig::ig
