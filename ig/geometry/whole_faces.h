#pragma once
/// Faces wholly in front of the near plane and inside the guard band, which nothing clips: nearly all that are put out.

#include "ig/active/face_block.h"
#include "ig/geometry/face_sieve.h"
#include "ig/geometry/projected_face.h"

#include <span>

namespace linkdig::ig {

/// What is common to the faces of a run.
struct WholeFaces {
    const FaceBlock* block = nullptr;
    const SeenVertex* seen = nullptr; ///< parallel to the block's vertices
    std::int32_t last_line = 0;       ///< 1/256 pixel: the picture's end
    std::int32_t last_element = 0;    ///< 1/256 pixel
    bool vertical = false;            ///< lines are columns
    ProjectedFace model;              ///< what does not depend on the face
};

/// Puts out what is seen of the faces, none of which has colours at its corners, in their order.
void put_whole_faces(const WholeFaces& common, std::span<const SiftedFace> faces, ProjectedFaces& projected);

} // namespace linkdig::ig
