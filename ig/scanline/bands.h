#pragma once
/// Which faces touch which band of lines, front to back.

#include "ig/edges/edge.h"
#include "ig/scanline/segment.h"

#include <cstdint>
#include <span>
#include <vector>

namespace linkdig::ig {

struct Bands {
    std::vector<std::uint32_t>
        first; ///< per band: where its ranks begin in `ranks`; one entry more at the end
    std::vector<std::uint32_t> ranks; ///< ascending within a band
    std::span<const std::uint32_t> of(std::size_t band) const {
        return {ranks.data() + first[band], ranks.data() + first[band + 1]};
    }
};

inline std::uint32_t band_count(std::uint32_t lines) { return (lines + band_lines - 1) / band_lines; }

void sort_into_bands(const FaceEdges& edges, std::uint32_t lines, Bands& bands);

} // namespace linkdig::ig
