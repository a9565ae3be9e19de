#pragma once
/// Vertices on their way into a channel, many at a time: transformed, lit, compared with the frustum, and placed on the raster
/// where they may be. Every level of SIMD gives the bits of the plain way (ig/geometry/project.cpp): single IEEE 754
/// operations in the same order.

#include "database/model/vectors.h"
#include "database/model/visual_database.h"
#include "ig/active/face_block.h"
#include "ig/geometry/view.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace linkdig::ig {

/// On which sides of the frustum a vertex lies outside, and whether it lies outside the guard band.
enum Outside : std::uint8_t { before_near = 1, left_of = 2, right_of = 4, below = 8, above = 16, guard = 32 };

/// z >= near_plane_m at w = 1; a direction (w = 0) must point a little forward, so that it lands somewhere. Between the
/// two, on an edge to infinity that passes the eye far from its near end (w is about that end's distance to the minus 1),
/// the plane stands least_forward / w before the eye: 0.2 mm at 20 km. With a thousandth it stood 20 m off, and the ground
/// at the eye's feet was missing.
inline constexpr double least_forward = 1e-8;

/// Clip planes stand a little inside the guard band, so that rounding stays within the format.
inline constexpr double guard_limit = 256.0 * (guard_pixels - 512);

/// How a block's vertices are seen and lit.
struct BlockView {
    const View* view = nullptr;
    const FaceBlock* block = nullptr;
    Mat3d channel_from_list{1.0};
    Vec3d origin{0}; ///< of the list, channel frame
};

struct VertexBatch {
    static constexpr std::size_t room = 128;
    std::size_t count = 0;
    std::array<std::uint32_t, room> index; ///< into the block's vertices
    alignas(64) std::array<std::array<float, room>, 4> position;
    alignas(64) std::array<std::array<float, room>, 3> normal;

    alignas(64) std::array<std::int32_t, room> snapped_line, snapped_element;
    alignas(64) std::array<std::int32_t, room> outside; ///< Outside
    alignas(64) std::array<std::int32_t, room> intensity;

    bool full() const { return count == room; }
    void add(std::uint32_t vertex_index, const Vertex& vertex) {
        index[count] = vertex_index;
        for (std::size_t c = 0; c < 4; ++c)
            position[c][count] = vertex.position[static_cast<int>(c)];
        for (std::size_t c = 0; c < 3; ++c)
            normal[c][count] = vertex.normal[static_cast<int>(c)];
        ++count;
    }
};

/// Works out what the batch's vertices are in the channel, from `snapped_line` on. Not where SIMD is switched off.
void see_batch(const BlockView& view, VertexBatch& batch);

} // namespace linkdig::ig
