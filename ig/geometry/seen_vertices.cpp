#include "ig/geometry/seen_vertices.h"

#include "ig/simd/simd_level.h"

#include <algorithm>

namespace linkdig::ig {

void SeenVertices::enter(const BlockView& view) {
    view_ = &view;
    const std::size_t groups = (view.block->vertices.size() + vertices_together - 1) / vertices_together;
    if (stamps_.size() < groups) {
        stamps_.resize(groups);
        seen_.resize(groups * vertices_together);
    }
    if (++stamp_ == 0) { // wrapped round: forget the old marks
        std::ranges::fill(stamps_, 0);
        stamp_ = 1;
    }
}

void SeenVertices::see_corners(std::uint32_t first, std::uint32_t count) {
    if (simd_is_off() || !see_range(first, count)) {
        const FaceBlock& block = *view_->block;
        for (std::uint32_t f = first; f < first + count; ++f) {
            const std::uint32_t* corners = block.corners.data() + block.faces[f].first_corner;
            for (std::uint32_t k = 0; k < block.faces[f].corner_count; ++k)
                want(corners[k] / vertices_together);
        }
    }
    see_wanted();
}

/// Where the faces' corners follow each other and want nearly all vertices of a range: no need to ask each. True if they do.
bool SeenVertices::see_range(std::uint32_t first, std::uint32_t count) {
    const FaceBlock& block = *view_->block;
    const std::uint32_t first_corner = block.faces[first].first_corner;
    std::uint32_t end_corner = first_corner;
    for (std::uint32_t f = first; f < first + count; ++f) {
        if (block.faces[f].first_corner != end_corner) return false;
        end_corner += block.faces[f].corner_count;
    }
    const std::uint32_t corners = end_corner - first_corner;
    const auto [least, greatest] = reach_of(block.corners.subspan(first_corner, corners));
    const std::uint32_t from = least / vertices_together;
    const std::uint32_t to = greatest / vertices_together;
    if ((to - from) * vertices_together > corners) return false;
    for (std::uint32_t group = from; group <= to; ++group)
        want(group);
    return true;
}

void SeenVertices::want(std::uint32_t group) {
    if (stamps_[group] == stamp_) return;
    stamps_[group] = stamp_;
    groups_[wanted_++] = group;
    if (wanted_ == groups_.size()) see_wanted();
}

void SeenVertices::see_wanted() {
    see_vertices(*view_, std::span(groups_).first(wanted_), seen_.data());
    wanted_ = 0;
}

} // namespace linkdig::ig
