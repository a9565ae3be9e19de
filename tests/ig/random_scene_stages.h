#pragma once
/// A scene through the machine's own stages: edges, scanline, video.

#include "ig/active/activate.h"
#include "ig/edges/edge.h"
#include "ig/priority/prioritise.h"
#include "ig/scanline/segment.h"
#include "ig/video/line.h"
#include "tests/ig/random_scene.h"

#include <vector>

namespace linkdig::ig {

/// A scene as the machine draws it, and what the stages handed on.
struct Drawn {
    FaceEdges edges;
    std::vector<BandSegments> bands;
    VideoFrame picture; ///< with its intensity and rank planes
};

/// What the stages up to geometry make of a packet's first channel.
struct Projected {
    ActiveDatabase active;
    PriorityOrder order;
    Scene scene;
};
Projected project_packet(const VisualDatabase& database, const FramePacket& packet, const Raster& raster);

/// Which bands each thread draws, one after the other, with working storage of its own.
Drawn draw(const Scene& scene, std::uint32_t threads = 1);

/// The second opinions of a scene (tests/support).
VideoFrame painted(const Scene& scene);
VideoFrame looped(const Scene& scene, const FaceEdges& edges);

/// Expects of the machine the same faces as the painter's and colours at most a level apart, and the classic
/// loop's bytes.
void expect_agreement(const Scene& scene);

} // namespace linkdig::ig
