#pragma once
/// What a channel's pixels are coloured from: the input of video.

#include "database/model/visual_database.h"
#include "ig/edges/edge.h"
#include "ig/geometry/projected_face.h"
#include "ig/video/face_air.h"
#include "ig/video/fog.h"

#include <span>

namespace linkdig::ig {

struct VideoInput {
    const ProjectedFaces* projected = nullptr;
    const FaceEdges* edges = nullptr;
    std::span<const Colour> colours; ///< of faces
    Colour background;
    const Air* air = nullptr;
    std::span<const Colour> light_colours{};
    std::span<const FaceAir> face_air{}; ///< of judge_air(); none where the air is clear
};

} // namespace linkdig::ig
