#pragma once
/// Edge smoothing of an opaque face: where its outline runs on many lines of a band at once, then areas and shares of many
/// elements of a line. What it does is what trace_line(), cover_line() (ig/scanline/coverage.h) and BandResolver
/// (ig/scanline/scanline.cpp) do line by line and element by element, and the same to the bit.

#include "ig/edges/edge.h"
#include "ig/scanline/opaque_faces.h"
#include "ig/scanline/segment.h"

#include <array>
#include <cstdint>

namespace linkdig::ig {

/// Elements that a face reaches at most on a line where it is narrow.
inline constexpr std::int32_t narrow_elements = 48;
/// And that it covers wholly between its sides, if it is wider than this: they are cheaper without areas. On wider lines
/// the elements that each side may cross.
inline constexpr std::int32_t few_elements = 16;
/// Edges that a face may have.
inline constexpr std::uint32_t most_outlines = 8;

/// The band as its faces change it.
struct SmoothedBand {
    OpenBand* open = nullptr;
    std::uint64_t* shared = nullptr; ///< BandSegments::shared
    std::uint32_t words = 0;         ///< of 64 elements, per line
    std::uint32_t* left = nullptr; ///< per element, of whole_pixel; room for narrow_elements behind the last
    std::int32_t elements = 0;
};

/// What is left to be done of a face in a band; a bit per line.
struct LinesLeft {
    std::uint32_t whole = 0; ///< of these the elements [begin, end), which it covers wholly
    std::uint32_t wide = 0;  ///< of these everything
    std::array<std::int32_t, band_lines> begin{}; ///< where `whole` says so
    std::array<std::int32_t, band_lines> end{};
};

/// Puts what an opaque face of at most most_outlines edges takes of the band's lines, but for what it leaves in `left`. Not where
/// SIMD is switched off.
void put_smoothed_lines(const FaceEdges& edges, std::uint32_t rank, const SmoothedBand& band,
                        BandSegments& segments, LinesLeft& left);

} // namespace linkdig::ig
