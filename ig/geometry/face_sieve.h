#pragma once
/// Which faces of a run may be seen, from what is known of their corners: most are beside the picture or lie between two lines'
/// centres, and nothing is written for them.

#include "ig/active/face_block.h"
#include "ig/geometry/vertex_batch.h"

#include <array>
#include <cstdint>

namespace linkdig::ig {

/// What a face is held against.
struct FaceSieve {
    std::int32_t last_line = 0;    ///< 1/256 pixel: the picture's end
    std::int32_t last_element = 0; ///< 1/256 pixel
    bool vertical = false;         ///< lines are columns
    bool low_faces = false;        ///< faces too low for any line's centre count
};

/// A face that is left.
struct SiftedFace {
    static constexpr std::uint32_t whole_mark = 1, level_mark = 2;
    std::uint32_t face = 0;  ///< into the block's faces
    std::uint32_t marks = 0; ///< and bits above of no meaning

    /// Wholly in front of the near plane and inside the guard band?
    bool whole() const { return (marks & whole_mark) != 0; }
    /// Have its corners one intensity? Of whole faces.
    bool level() const { return (marks & level_mark) != 0; }
};

/// Faces that go through together.
inline constexpr std::uint32_t faces_together = 64;

struct SiftedFaces {
    std::uint32_t count = 0;
    std::array<SiftedFace, faces_together> faces;
};

/// Sifts `count` faces from number `first` on, at most faces_together. Their corners must have been seen. False, and
/// nothing is sifted, where there are no vectors.
bool sift_faces(const FaceSieve& sieve, const FaceBlock& block, const SeenVertex* seen, std::uint32_t first,
                std::uint32_t count, SiftedFaces& left);

} // namespace linkdig::ig
