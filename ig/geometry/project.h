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
#include "ig/geometry/parts.h"
#include "ig/geometry/projected_face.h"
#include "ig/geometry/vertex_batch.h"
#include "ig/geometry/view.h"
#include "ig/priority/ranked_run.h"

namespace linkdig::ig {

/// A vertex as the channel sees it, computed once per block. Small, because a face's lie far apart.
struct SeenVertex {
    RasterPoint snapped;        ///< meaningful in front of the near plane and inside the guard band
    std::uint32_t stamp = 0;    ///< block visit it was computed for
    std::int32_t intensity = 0; ///< 1.0 = 2^22
    std::uint8_t outside = 0;   ///< Outside
    bool lit = false;           ///< the intensity is there
};

struct GeometryScratch {
    std::vector<SeenVertex> seen;
    VertexBatch batch;
    std::uint32_t stamp = 0;
    std::vector<ClipPoint> whole; ///< the face as it came
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

/// Intensity of a normal under a block's light: ambient + diffuse * max(0, n.s), clamped to [0, 1], 1.0 =
/// 2^22.
std::int32_t lit_intensity(const FaceBlock& block, const Vec3f& normal);

} // namespace linkdig::ig
