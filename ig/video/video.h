#pragma once
/// Stage 6, video: segments become pixels. A pixel is colour code x intensity, rounded once, written once.

#include "database/model/visual_database.h"
#include "ig/configuration.h"
#include "ig/edges/edge.h"
#include "ig/geometry/projected_face.h"
#include "ig/scanline/segment.h"
#include "ig/video/add_lights.h"
#include "ig/video/line.h"
#include "ig/video/pixel_run.h"

#include <span>

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

/// Sizes the frame; planes that are wanted are sized, others emptied. Contents are undefined until every band
/// is drawn.
void open_frame(const Raster& raster, bool intensity, bool rank, VideoFrame& frame);

/// What the shares of a pixel have added up to: component x weight, components with 7 fraction bits.
struct PixelSum {
    std::uint32_t red = 0, green = 0, blue = 0;
    std::int32_t pending =
        -1; ///< latest additive face that waits for what is behind it: into the pending list
    std::uint32_t rank = ~0U; ///< of the face with the largest share so far
    std::uint32_t rank_weight = 0;
    std::int32_t intensity = -1; ///< of that face
};

/// An additive face over a pixel, until the next ordinary face tells whether it counts.
struct PendingLight {
    std::uint32_t red = 0, green = 0, blue = 0; ///< 7 fraction bits
    std::int32_t added_to = -1;
    std::int32_t before = -1; ///< the one pending before it
};

/// Working storage of one thread: a band of a vertical scan, line by line, before it is turned into the
/// picture's rows.
struct VideoScratch {
    std::vector<std::uint32_t> lines;
    std::vector<PixelSum> sums; ///< parallel to BandSegments::pixels
    std::vector<PendingLight> pending;
    LightSums lights;
    std::uint64_t light_pixels = 0; ///< of the band drawn last: pixels that light points brighten
};

/// Draws one band. Bands of one frame may be drawn at the same time, each thread with its own scratch.
void draw_band(const VideoInput& input, const Raster& raster, const BandSegments& segments,
               VideoScratch& scratch, VideoFrame& frame);

} // namespace linkdig::ig
