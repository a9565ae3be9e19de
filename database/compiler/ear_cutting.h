#pragma once
/// Polygons of meshes that are no faces as they stand: not planar, or concave.

#include "database/model/vectors.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace linkdig::database {

/// Triangles over the polygon's corners, by cutting ears (Meisters, Polygons have ears, 1975): n - 2 of them. Seen along
/// the polygon's own normal; of a polygon that intersects itself there they overlap.
std::vector<std::array<std::uint32_t, 3>> cut_ears(std::span<const Vec3d> corners);

} // namespace linkdig::database
