#pragma once
/// Consecutive shares of one face: its colour, times a weight per pixel, added to sums. The inner loop of smoothed edges,
/// once for every SIMD level (ig/video/pixel_run.h chooses it); only integers, the same sums from each.

#include "ig/video/pixel_run.h"

#include <cstdint>

namespace linkdig::ig {

/// What a run's pixels are coloured with.
struct RunColour {
    Colour colour;
    IntensityPlane plane;
    std::int32_t transmission = -1; ///< of the air before it, the same for all its pixels; -1: clear
    Colour horizon;
};

/// Sums of consecutive pixels: components with 7 fraction bits x weights. `padding` more of each can be written, and are
/// left as they are.
struct SumsAt {
    std::uint32_t* red = nullptr;
    std::uint32_t* green = nullptr;
    std::uint32_t* blue = nullptr;
};
inline constexpr std::size_t sums_padding = 16;

/// Adds `count` pixels of a line from `element` on. weights_padding more weights can be read.
void add_share_run(const RunColour& run, std::int32_t line, std::int32_t element, std::uint32_t count,
                   const std::uint32_t* weights, const SumsAt& sums);

} // namespace linkdig::ig
