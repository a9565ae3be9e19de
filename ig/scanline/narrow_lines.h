#pragma once
/// Edge smoothing of an opaque face on a line where it is narrow: areas and shares of all its elements at once. What it does is
/// what cover_line() and BandResolver (ig/scanline/scanline.cpp) do element by element, and the same to the bit; but the
/// shares of the line are one run.

#include "ig/scanline/coverage.h"
#include "ig/scanline/open_mask.h"
#include "ig/scanline/segment.h"

#include <algorithm>
#include <cstdint>

namespace linkdig::ig {

/// Elements that a face reaches at most on a line where it is narrow.
inline constexpr std::int32_t narrow_elements = 48;
/// And that it covers wholly between its sides, if it is wider than this: they are cheaper without areas.
inline constexpr std::int32_t few_elements = 16;

/// One line of a band, as its faces change it.
struct BandLine {
    LineMask open;                   ///< a bit per element, and a spare word
    std::uint64_t* shared = nullptr; ///< likewise; the next line, or a spare word, follows
    std::uint32_t* left = nullptr; ///< per element, of whole_pixel; room for narrow_elements behind the last
    std::uint16_t number = 0;
};

/// Is the face narrow there, and wholly within the raster?
inline bool is_narrow(const OutlineLine& traced, std::int32_t elements) {
    const std::int32_t begin = std::min(traced.leading.begin, traced.trailing.begin);
    const std::int32_t end = std::max(traced.leading.end, traced.trailing.end);
    if (begin < 0 || end > elements || end - begin > narrow_elements) return false;
    return end - begin <= few_elements || traced.trailing.begin - traced.leading.end <= few_elements;
}

/// Puts what the face takes of the line; returns how many elements are closed by it. Not where SIMD is switched off.
std::uint32_t put_narrow_line(const OutlineLine& traced, std::uint32_t rank, const BandLine& line,
                              BandSegments& band);

} // namespace linkdig::ig
