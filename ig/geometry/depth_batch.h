#pragma once
/// The depth planes of a block's faces, many at a time: wanted one by one, when a face is put out, and made together later.
/// Every level of SIMD gives the bits of the plain way (depth_plane()): single IEEE 754 operations in the same order.

#include "ig/geometry/clip.h"
#include "ig/geometry/projected_face.h"
#include "ig/geometry/vertex_batch.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace linkdig::ig {

/// Depth planes that are made together, at most.
inline constexpr std::uint32_t depths_together = 64;

/// Makes the depth planes of these faces of the block, at most depths_together, into `planes`, parallel to them. `corners` is
/// working storage.
void make_depth_planes(const BlockView& view, std::span<const std::uint32_t> faces,
                       std::vector<ClipPoint>& corners, DepthPlane* planes);

/// Depth planes that are wanted and not yet made: they will stand behind `depths`, which nothing else adds to meanwhile.
class DepthBatch {
public:
    /// Nothing is wanted.
    void clear() { count_ = 0; }

    /// That of a face of the block. Returns its place in `depths`.
    std::int32_t want(const BlockView& view, std::uint32_t face, std::vector<DepthPlane>& depths) {
        if (count_ == depths_together) make(view, depths);
        faces_[count_] = face;
        return static_cast<std::int32_t>(depths.size() + count_++);
    }

    /// Makes those that are wanted. Before another block is entered, and at the end.
    void make(const BlockView& view, std::vector<DepthPlane>& depths) {
        const std::size_t first = depths.size();
        depths.resize(first + count_);
        make_depth_planes(view, std::span(faces_).first(count_), corners_, depths.data() + first);
        count_ = 0;
    }

private:
    std::uint32_t count_ = 0;
    std::array<std::uint32_t, depths_together> faces_{}; ///< of the block
    std::vector<ClipPoint> corners_;
};

} // namespace linkdig::ig
