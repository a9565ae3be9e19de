#pragma once
/// A band's faces stand far apart in memory.

#include "ig/edges/edge.h"
#include "ig/prefetch.h"

#include <cstdint>
#include <span>

namespace linkdig::ig {

/// Asks for faces that are soon needed, and for their edges (with smoothing their outlines) when the faces are there. `ranks`:
/// those that are still to come, the one at hand first.
LINKDIG_ALWAYS_INLINE void fetch_ahead(const FaceEdges& edges, std::span<const std::uint32_t> ranks,
                                       bool smoothing) {
    constexpr std::size_t faces_ahead = 32, edges_ahead = 12;
    if (ranks.size() > faces_ahead) prefetch(&edges.faces[ranks[faces_ahead]]);
    if (ranks.size() <= edges_ahead) return;
    const EdgeFace& face = edges.faces[ranks[edges_ahead]];
    if (smoothing) {
        prefetch(edges.outlines.data() + face.first_outline);
        prefetch(edges.outlines.data() + face.first_outline + 2);
    } else {
        prefetch(edges.edges.data() + face.first_edge);
        prefetch(edges.edges.data() + face.first_edge + 2);
    }
}

} // namespace linkdig::ig
