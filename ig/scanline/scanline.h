#pragma once
/// Stage 5, scanline: hidden faces removed by priority alone. Faces come front to back; a mask per line
/// remembers which elements are still open; a face gets what is open between its crossings. No depth is ever
/// compared.

#include "ig/configuration.h"
#include "ig/edges/edge.h"
#include "ig/scanline/segment.h"

#include <array>
#include <span>

namespace linkdig::ig {

/// Working storage of one thread.
struct BandScratch {
    std::vector<std::uint64_t> open;                    ///< a bit per element, `words` per line: 1 = open
    std::array<std::uint32_t, band_lines> open_count{}; ///< elements still open on each line
    std::array<std::int32_t, band_lines> begin{};       ///< of the face at hand
    std::array<std::int32_t, band_lines> end{};
};

/// Resolves the lines [segments.first_line, segments.end_line), at most band_lines, for the faces of these
/// ranks.
void resolve_band(const FaceEdges& edges, std::span<const std::uint32_t> ranks, std::uint32_t elements,
                  BandScratch& scratch, BandSegments& segments);

} // namespace linkdig::ig
