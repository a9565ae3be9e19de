#pragma once
/// Vertices on their way into a channel, many at a time: transformed, lit, compared with the frustum, and placed on the raster
/// where they may be. Every level of SIMD gives the bits of the plain way (see_plainly()): single IEEE 754 operations in the same
/// order.

#include "database/model/vectors.h"
#include "database/model/visual_database.h"
#include "ig/active/face_block.h"
#include "ig/floor.h"
#include "ig/geometry/clip.h"
#include "ig/geometry/view.h"

#include <cstdint>
#include <span>

namespace linkdig::ig {

/// On which sides of the frustum a vertex lies outside, and whether it lies outside the guard band.
enum Outside : std::uint8_t { before_near = 1, left_of = 2, right_of = 4, below = 8, above = 16, guard = 32 };

inline constexpr std::int32_t frustum_sides = before_near | left_of | right_of | below | above;

/// z >= near_plane_m at w = 1; a direction (w = 0) must point a little forward, so that it lands somewhere. Between the
/// two, on an edge to infinity that passes the eye far from its near end (w is about that end's distance to the minus 1),
/// the plane stands least_forward / w before the eye: 0.2 mm at 20 km. With a thousandth it stood 20 m off, and the ground
/// at the eye's feet was missing.
inline constexpr double least_forward = 1e-8;

inline constexpr ClipPlane near_plane{
    .c = 1.0, .e = least_forward - near_plane_m, .constant = -least_forward};

/// Clip planes stand a little inside the guard band, so that rounding stays within the format.
inline constexpr double guard_limit = 256.0 * (guard_pixels - 512);

/// How a block's vertices are seen and lit.
struct BlockView {
    const View* view = nullptr;
    const FaceBlock* block = nullptr;
    Mat3d channel_from_list{1.0};
    Vec3d origin{0}; ///< of the list, channel frame
};

/// A vertex as the channel sees it. What is asked of a face's corners is asked of all four numbers at once (face_sieve.cpp).
struct alignas(16) SeenVertex {
    RasterPoint snapped;        ///< meaningful in front of the near plane and inside the guard band
    std::int32_t intensity = 0; ///< 1.0 = 2^22
    std::int32_t outside = 0;   ///< Outside
};

/// Vertices are seen in groups of as many that follow each other in the block, the first of which is a multiple of it: faces
/// near each other have corners near each other.
inline constexpr std::uint32_t vertices_together = 8;

/// Sees these groups of the block's vertices, into `seen`, parallel to them. The last one may lack some.
void see_vertices(const BlockView& view, std::span<const std::uint32_t> groups, SeenVertex* seen);

/// Least and greatest of some indices.
struct Reach {
    std::uint32_t least = 0;
    std::uint32_t greatest = 0;
};
Reach reach_of(std::span<const std::uint32_t> indices);

/// Sees one vertex, without vectors.
void see_plainly(const BlockView& view, const Vertex& vertex, SeenVertex& seen);

/// A vertex's position in the channel frame.
ClipPoint channel_point(const BlockView& view, const Vec4f& position, std::int32_t intensity = 0);

/// Raster position of a point in front of the near plane, in 1/256 pixel.
void raster_position(const View& view, const ClipPoint& point, double& line, double& element);

/// To the nearest whole number. |value| < 2^62.
inline double snap(double value) { return static_cast<double>(floor_of(value + 0.5)); }

/// Intensity of a normal under a block's light: ambient + diffuse * max(0, n.s), clamped to [0, 1], 1.0 = 2^22.
std::int32_t lit_intensity(const FaceBlock& block, const Vec3f& normal);

} // namespace linkdig::ig
