#pragma once
/// The shared pixels of a band: shares are added up front to back, each pixel is rounded, clamped and written once.

#include "database/model/visual_database.h"
#include "ig/edges/edge.h"
#include "ig/geometry/projected_face.h"
#include "ig/scanline/segment.h"
#include "ig/video/beam.h"
#include "ig/video/fog.h"

#include <cstdint>
#include <span>
#include <vector>

namespace linkdig::ig {

/// What a channel's bands are coloured with.
struct VideoInput {
    const ProjectedFaces* projected = nullptr;
    const FaceEdges* edges = nullptr;
    std::span<const Colour> colours; ///< of faces
    Colour background;
    const Air* air = nullptr;
    std::span<const Colour> light_colours{};
};

/// Of a shared pixel, where planes are wanted or light is added.
struct PixelTale {
    std::int32_t pending =
        -1; ///< latest additive face that waits for what is behind it: into the pending list
    std::uint32_t rank = background_rank; ///< of the face with the largest share so far
    std::uint32_t rank_weight = 0;
    std::int32_t intensity = -1; ///< of that face
};

/// An additive face over a pixel, until the next ordinary face tells whether it counts.
struct PendingLight {
    std::uint32_t red = 0, green = 0, blue = 0; ///< 7 fraction bits
    std::int32_t added_to = -1;
    std::int32_t before = -1; ///< the one pending before it
};

/// Working storage of one thread: per element of the band what its shares have added up to, component x weight,
/// components with 7 fraction bits. All zero between bands, and sums_padding more.
struct ShareSums {
    std::vector<std::uint32_t> red, green, blue;
    std::vector<PixelTale> tales; ///< per element; as made between bands
    std::vector<PendingLight> pending;
};

/// Draws the shared pixels of a band.
void draw_shares(const VideoInput& input, const Raster& raster, const BandSegments& band,
                 const BeamBuffer& beam, ShareSums& sums, VideoFrame& frame);

} // namespace linkdig::ig
