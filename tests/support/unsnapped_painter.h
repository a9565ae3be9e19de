#pragma once
/// A painter that knows no raster: each pixel's ray against the faces as they stand in space, in priority order, in long
/// doubles. It shares the order of the runs with the machine, and neither transform, clip, projection nor snap.

#include "host/packet/frame_packet.h"
#include "ig/active/face_block.h"
#include "ig/configuration.h"
#include "ig/priority/ranked_run.h"

#include <cstdint>
#include <vector>

namespace linkdig::support {

/// What a pixel shows: a face of a block, or nothing (both -1).
struct SeenFace {
    std::int64_t block = -1;
    std::int64_t face = -1;
    bool near_an_edge =
        false; ///< less than `margin` pixels from the border of a face that is in front, or seen there
    bool same_face(const SeenFace& other) const { return block == other.block && face == other.face; }
};

/// Row by row from the top, as the viewer sees it. `margin` in pixels.
std::vector<SeenFace> paint_unsnapped(const ig::ActiveDatabase& active, const ig::PriorityOrder& order,
                                      const ChannelView& channel, const ig::Raster& raster, double margin);

} // namespace linkdig::support
