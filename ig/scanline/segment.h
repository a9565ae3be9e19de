#pragma once
/// Output of scanline: the visible runs of a band of lines, and the shares of the pixels that several faces have.

#include <cstdint>
#include <vector>

namespace linkdig::ig {

/// Lines that are resolved together.
inline constexpr std::uint32_t band_lines = 32;

/// Elements [first, first + count) of a line show the face of this rank and nothing else.
struct Segment {
    std::uint32_t face = 0; ///< rank: into ProjectedFaces::faces
    std::uint16_t line = 0;
    std::uint16_t first = 0;
    std::uint16_t count = 0;
};

/// A whole pixel, in the units of shares: twice 1/256 x 1/256 pixel, so that areas of trapezia are whole numbers.
inline constexpr std::uint32_t whole_pixel = 1U << 17U;

/// A pixel that is shared: by faces whose edge crosses it, by a semi-opaque face and what is behind it, or by an
/// additive face and what it brightens.
struct SharedPixel {
    std::uint16_t line = 0;
    std::uint16_t element = 0;
    std::uint32_t left = whole_pixel; ///< what no face has taken
    /// The level of detail that fades over this pixel, and what its faces would have left if it did not: those behind
    /// others of the level stay hidden by them.
    std::int32_t level = -1;
    std::uint32_t left_by_level = 0;
};

/// The rank that stands for the background in a share.
inline constexpr std::uint32_t background_rank = ~0U;

/// One face's share of one pixel. Shares of a pixel come front to back; those of ordinary faces and of the background
/// sum to whole_pixel exactly.
struct Share {
    std::uint32_t face = 0;   ///< rank
    std::uint32_t pixel = 0;  ///< into BandSegments::pixels
    std::uint32_t weight = 0; ///< of whole_pixel; of an additive face: its coverage
};

/// What a light point adds to one pixel, after what is in front of it has taken its part.
struct LightPixel {
    std::uint16_t line = 0;
    std::uint16_t element = 0;
    std::uint32_t weight = 0; ///< of whole_splat (ig/lights/splat.h)
    std::uint32_t light = 0;  ///< into ProjectedFaces::lights
};

/// One band, in the order in which it was resolved: by rank, then line, then element. Every element belongs to exactly
/// one segment, to the background, or to `pixels`.
struct BandSegments {
    std::uint32_t first_line = 0;
    std::uint32_t end_line = 0;
    std::vector<Segment> segments;
    std::vector<Segment> background; ///< what no face covers; `face` is meaningless
    std::vector<SharedPixel> pixels;
    std::vector<Share> shares;
    std::vector<LightPixel> lights;
};

} // namespace linkdig::ig
