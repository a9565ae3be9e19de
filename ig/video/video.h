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
#include "ig/video/share_sums.h"

#include <span>

namespace linkdig::ig {

/// Sizes the frame; planes that are wanted are sized, others emptied. Contents are undefined until every band
/// is drawn.
void open_frame(const Raster& raster, bool intensity, bool rank, VideoFrame& frame);

/// Working storage of one thread: a band of a vertical scan, line by line, before it is turned into the
/// picture's rows.
struct VideoScratch {
    std::vector<std::uint32_t> lines;
    ShareSums shares;
    LightSums lights;
    std::uint64_t light_pixels = 0; ///< of the band drawn last: pixels that light points brighten
};

/// Draws one band. Bands of one frame may be drawn at the same time, each thread with its own scratch.
void draw_band(const VideoInput& input, const Raster& raster, const BandSegments& segments,
               VideoScratch& scratch, VideoFrame& frame);

} // namespace linkdig::ig
