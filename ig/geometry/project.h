#pragma once
/// Stage 3, geometry: transform, light by the list's own sun, cut into triangles, clip, project, snap.
///
/// Order matters (report, Appendix I; docs/frame-in-detail.md): smooth-shaded faces are cut into triangles
/// before any clipping, and a triangle keeps the intensities of its own unclipped corners. Only the near
/// plane clips in 3D; beyond the sides of the picture only the guard band does, which leaves edges on their
/// lines.

#include "ig/active/face_block.h"
#include "ig/configuration.h"
#include "ig/geometry/clip.h"
#include "ig/geometry/depth_batch.h"
#include "ig/geometry/face_sieve.h"
#include "ig/geometry/parts.h"
#include "ig/geometry/projected_face.h"
#include "ig/geometry/seen_vertices.h"
#include "ig/geometry/view.h"
#include "ig/priority/ranked_run.h"

namespace linkdig::ig {

struct GeometryScratch {
    SeenVertices seen;
    SiftedFaces sifted;
    DepthBatch depths;
    std::vector<ClipPoint> polygon;
    std::vector<ClipPoint> spare;
    std::vector<ClipPoint> pieces;
};

/// What the later stages need of the faces.
struct GeometryNeeds {
    bool depth = false;     ///< depth planes (limited visibility), though never of what is centred on the eye
    bool low_faces = false; ///< faces too low for any line's centre, which only smoothed edges show
};

/// Projects the present faces of a part of the priority order. The result's order is the rank.
void project(const ActiveDatabase& active, const PriorityOrder& order, const OrderPart& part,
             const ChannelView& channel, const Raster& raster, const GeometryNeeds& needs,
             GeometryScratch& scratch, ProjectedFaces& projected);

} // namespace linkdig::ig
