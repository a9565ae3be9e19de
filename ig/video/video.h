#pragma once
/// Stage 6, video: segments become pixels. A pixel is colour code x intensity, rounded once, written once.

#include "database/model/visual_database.h"
#include "ig/configuration.h"
#include "ig/edges/edge.h"
#include "ig/geometry/projected_face.h"
#include "ig/scanline/segment.h"
#include "ig/video/line.h"

#include <span>

namespace linkdig::ig {

/// What a channel's bands are coloured with.
struct VideoInput {
    const ProjectedFaces* projected = nullptr;
    const FaceEdges* edges = nullptr;
    std::span<const Colour> colours;
    Colour background;
};

/// A colour code at an intensity (1.0 = 2^22): each component x intensity, rounded to the nearest level.
inline std::uint32_t shade(Colour colour, std::int32_t intensity) {
    const auto i = static_cast<std::uint32_t>(intensity);
    constexpr std::uint32_t half = 1U << 21U;
    return ((colour.red * i + half) >> 22U) | ((colour.green * i + half) >> 22U) << 8U |
           ((colour.blue * i + half) >> 22U) << 16U | 0xff000000U;
}

/// Sizes the frame; planes that are wanted are sized, others emptied. Contents are undefined until every band
/// is drawn.
void open_frame(const Raster& raster, bool intensity, bool rank, VideoFrame& frame);

/// Draws one band. Bands of one frame may be drawn at the same time.
void draw_band(const VideoInput& input, const Raster& raster, const BandSegments& segments,
               VideoFrame& frame);

} // namespace linkdig::ig
