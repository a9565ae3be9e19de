#pragma once
/// Output of scanline: the visible runs of a band of lines, and the shares of the pixels that several faces have.

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace linkdig::ig {

/// Lines that are resolved together.
inline constexpr std::uint32_t band_lines = 32;

/// Elements [first, first + count) of a line show one face and nothing else.
struct Segment {
    std::uint16_t line = 0;
    std::uint16_t first = 0;
    std::uint16_t count = 0;
    std::uint16_t unused = 0; ///< makes it a word of 64 bits
};

/// Segments of one face: those from where the face's before it end.
struct FaceSegments {
    std::uint32_t face = 0; ///< rank: into ProjectedFaces::faces
    std::uint32_t end = 0;  ///< into BandSegments::segments
};

/// A whole pixel, in the units of shares: twice 1/256 x 1/256 pixel, so that areas of trapezia are whole numbers.
inline constexpr int whole_pixel_bits = 17;
inline constexpr std::uint32_t whole_pixel = 1U << whole_pixel_bits;

/// The rank that stands for the background in a share.
inline constexpr std::uint32_t background_rank = ~0U;

/// Leaves new elements as they are: whoever makes room writes them.
template <typename Value>
struct Unwritten : std::allocator<Value> {
    template <typename Other>
    struct rebind {
        using other = Unwritten<Other>;
    };
    void construct(Value* /*place*/) noexcept {}
    template <typename... Arguments>
    void construct(Value* place, Arguments&&... arguments) {
        std::construct_at(place, std::forward<Arguments>(arguments)...);
    }
};

using SegmentList = std::vector<Segment, Unwritten<Segment>>;
using FaceSegmentsList = std::vector<FaceSegments, Unwritten<FaceSegments>>;

/// One face's shares of consecutive pixels that it does not have alone: pixels that an edge crosses, that a semi-opaque
/// face lies before, or that an additive face brightens. Shares of a pixel come front to back; those of ordinary faces
/// and of the background sum to whole_pixel exactly.
struct ShareRun {
    std::uint32_t face = 0; ///< rank
    std::uint32_t first_weight =
        0; ///< into BandSegments::weights: of whole_pixel, may be 0; of an additive face its coverage
    std::uint16_t line = 0;
    std::uint16_t first = 0;
    std::uint16_t count = 0;
};

/// Room behind the last weight, so that whole vectors can be read.
inline constexpr std::size_t weights_padding = 16;

/// What a light point adds to one pixel, after what is in front of it has taken its part.
struct LightPixel {
    std::uint16_t line = 0;
    std::uint16_t element = 0;
    std::uint32_t weight = 0; ///< of whole_splat (ig/lights/splat.h)
    std::uint32_t light = 0;  ///< into ProjectedFaces::lights
};

/// One band, in the order in which it was resolved: by rank; the segments of one face in any order, its shares by line and
/// element. Every element belongs to exactly one segment, to the background, or to the shared pixels.
struct BandSegments {
    std::uint32_t first_line = 0;
    std::uint32_t end_line = 0;
    FaceSegmentsList faces; ///< that have segments
    SegmentList segments;
    alignas(64) std::array<std::uint64_t, band_lines> on_line{}; ///< segments of each line
    SegmentList background;                                      ///< what no face covers
    std::uint32_t words = 0;                                     ///< of 64 elements, per line
    std::vector<std::uint64_t> shared;                           ///< a bit per element: 1 = a shared pixel
    std::vector<ShareRun> shares;
    std::vector<std::uint32_t, Unwritten<std::uint32_t>> weights; ///< and weights_padding more
    std::vector<LightPixel> lights;
};

} // namespace linkdig::ig
