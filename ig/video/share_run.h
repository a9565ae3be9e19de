#pragma once
/// Consecutive shares of one face: its colour, times a weight per pixel, added to sums. The inner loop of smoothed edges,
/// once for every SIMD level (ig/video/pixel_run.h chooses it); only integers, the same sums from each.

#include "ig/video/pixel_run.h"

#include <cstdint>
#include <span>

namespace linkdig::ig {

/// The most of a component, 7 fraction bits.
inline constexpr std::uint32_t brightest = 255U << 7U;

/// What a run's pixels are coloured with.
struct RunColour {
    Colour colour;
    IntensityPlane plane;
    bool in_air = false;
    IntensityPlane transmission; ///< of the air before it, 1.0 = 2^22, if it is `in_air`
    Colour horizon;
};

/// Sums of a band's pixels, line after line of `elements`: components with 7 fraction bits, x weights where nothing else is said.
/// `sums_padding` more of each can be written, and are left as they are.
struct BandSums {
    std::uint32_t* red = nullptr;
    std::uint32_t* green = nullptr;
    std::uint32_t* blue = nullptr;
    std::uint32_t first_line = 0;
    std::uint32_t elements = 0;

    std::size_t at(std::uint32_t line, std::uint32_t element) const {
        return std::size_t{line - first_line} * elements + element;
    }
};
inline constexpr std::size_t sums_padding = 16;

/// Adds runs of one face: colour x weight. weights_padding more weights can be read.
void add_share_runs(const RunColour& colour, std::span<const ShareRun> runs, const std::uint32_t* weights,
                    const BandSums& sums);

/// The same of a face that `light`, components of the band's pixels, brightens first: both together are clamped once.
void add_lit_runs(const RunColour& colour, std::span<const ShareRun> runs, const std::uint32_t* weights,
                  const BandSums& light, const BandSums& sums);

/// Adds the face's own part, colour x weight / whole_pixel, to `light`, which waits for the face behind it.
void add_light_runs(const RunColour& colour, std::span<const ShareRun> runs, const std::uint32_t* weights,
                    const BandSums& light);

/// Rounds the sums of the elements of a line from `element` on whose bits are set to levels, writes them, and makes the sums
/// nought.
void write_shares(const BandSums& sums, std::uint32_t line, std::uint32_t element, std::uint64_t shared,
                  std::uint32_t* pixels);

} // namespace linkdig::ig
