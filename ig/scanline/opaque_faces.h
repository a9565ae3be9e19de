#pragma once
/// Opaque faces, several lines at once: the scanline stage where vectors serve it. What it does with a face is what
/// BandResolver (ig/scanline/scanline.cpp) does line by line; the segments of a face are the same, in another order.

#include "ig/edges/edge.h"
#include "ig/scanline/open_mask.h"
#include "ig/scanline/segment.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace linkdig::ig {

/// The words of the same 64 elements of all lines of a band stand together: a vector holds those of several lines.
struct alignas(64) OpenWords {
    std::array<std::uint64_t, band_lines> of_line{};
};

/// Lines [from, to) of a band.
struct LineRange {
    std::size_t from = 0;
    std::size_t to = 0;
};

/// What is still open of a band of lines.
struct OpenBand {
    std::int32_t first_line = 0;
    std::int32_t end_line = 0;
    std::vector<OpenWords>
        open; ///< a bit per element: 1 = something is left; behind the last there are spare ones
    alignas(64) std::array<std::uint64_t, band_lines> count{}; ///< elements still open on each line
    std::uint32_t open_lines = 0;                              ///< lines with an open element

    /// The lines of the band, from its first one on, that a face touches.
    LineRange lines_of(const EdgeFace& face) const {
        const std::int32_t from = std::max(face.first_line, first_line) - first_line;
        const std::int32_t to = std::max(std::min(face.end_line, end_line) - first_line, from);
        return {static_cast<std::size_t>(from), static_cast<std::size_t>(to)};
    }

    LineMask line(std::size_t number) { return {open.front().of_line.data() + number, band_lines}; }
};

/// Takes for each face of these ranks, front to back, what is open between its crossings, until a face comes that blends, or
/// nothing is open. Returns how many faces it has dealt with: none on a machine without vectors.
std::size_t take_opaque_faces(const FaceEdges& edges, std::span<const std::uint32_t> ranks, OpenBand& band,
                              BandSegments& segments);

} // namespace linkdig::ig
