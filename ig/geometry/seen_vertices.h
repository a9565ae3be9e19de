#pragma once
/// The vertices of one block as the channel sees them, each seen once, when a face first asks for it.

#include "ig/geometry/vertex_batch.h"

#include <array>
#include <cstdint>
#include <vector>

namespace linkdig::ig {

class SeenVertices {
public:
    /// From now on those of another block; none of them has been seen. `view` must last.
    void enter(const BlockView& view);

    /// Sees the corners of `count` faces of the block, from number `first` on.
    void see_corners(std::uint32_t first, std::uint32_t count);

    /// One that has been seen.
    const SeenVertex& operator[](std::uint32_t index) const { return seen_[index]; }
    const SeenVertex* data() const { return seen_.data(); }

private:
    bool see_range(std::uint32_t first, std::uint32_t count);
    void want(std::uint32_t group);
    void see_wanted();

    const BlockView* view_ = nullptr;
    std::vector<SeenVertex> seen_;      ///< parallel to the block's vertices, in whole groups
    std::vector<std::uint32_t> stamps_; ///< of vertices_together each: the visit that they were seen in
    std::uint32_t stamp_ = 0;           ///< of this visit
    std::uint32_t wanted_ = 0;          ///< groups that are waiting to be seen
    std::array<std::uint32_t, 64> groups_{};
};

} // namespace linkdig::ig
