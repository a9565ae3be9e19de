#pragma once
/// The pattern of a repeated tile: keys of [[tile]] become tables of normals.

#include "database/compiler/model_object.h"

#include <vector>

namespace linkdig::database {

struct TilePattern {
    std::vector<Vec3f> vertices;
    std::vector<Vec3f> faces; ///< as many
};

/// Reads `pattern` and the keys that go with it. The tile's period and cell_m are read already; its vertical angle is set
/// here. Tables of waves and levels, and those of face-shaded squares, are followed by coarser ones
/// (database/model/tile_tables.h). After a mistake the tables may be empty.
TilePattern read_pattern(TableReader& reader, RepeatedTile& tile, bool face_shaded);

/// Least squares that a wave may have: fewer, and it is no wave to be seen.
inline constexpr double least_squares_of_wave = 4.0;
/// How far a wave may be from the nearest one that repeats over the pattern, and is then taken for it.
inline constexpr double most_wave_misfit = 0.05;     ///< of its length
inline constexpr double most_angle_misfit_deg = 3.0; ///< of its direction

} // namespace linkdig::database
