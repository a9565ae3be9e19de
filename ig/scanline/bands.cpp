#include "ig/scanline/bands.h"

namespace linkdig::ig {

namespace {

std::uint32_t first_band(const EdgeFace& face) {
    return static_cast<std::uint32_t>(face.first_line) / band_lines;
}
std::uint32_t last_band(const EdgeFace& face) {
    return static_cast<std::uint32_t>(face.end_line - 1) / band_lines;
}

} // namespace

void sort_into_bands(const FaceEdges& edges, std::uint32_t lines, Bands& bands) {
    bands.first.assign(band_count(lines) + 1, 0);
    for (const EdgeFace& face : edges.faces) {
        if (face.first_line >= face.end_line) continue;
        for (std::uint32_t band = first_band(face); band <= last_band(face); ++band)
            ++bands.first[band + 1];
    }
    for (std::size_t band = 1; band < bands.first.size(); ++band)
        bands.first[band] += bands.first[band - 1];
    bands.ranks.resize(bands.first.back());
    // Fill from the front, then shift the starts back by one: ranks ascend because the faces come in rank
    // order.
    for (std::uint32_t rank = 0; rank < edges.faces.size(); ++rank) {
        const EdgeFace& face = edges.faces[rank];
        if (face.first_line >= face.end_line) continue;
        for (std::uint32_t band = first_band(face); band <= last_band(face); ++band) {
            bands.ranks[bands.first[band]++] = rank;
        }
    }
    for (std::size_t band = bands.first.size() - 1; band > 0; --band)
        bands.first[band] = bands.first[band - 1];
    bands.first[0] = 0;
}

} // namespace linkdig::ig
