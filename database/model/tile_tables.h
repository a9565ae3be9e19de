#pragma once
/// Bounds of a repeated tile, and how its tables lie in VisualDatabase::tile_normals; where they begin says which there are.
///
/// A random pattern has period^2 vertex normals, then period^2 of its squares; coarser rings use every 2^k-th of them. A
/// pattern of waves or levels follows each of the two with its *coarser tables*, of half, a quarter ... the side, the last of
/// one normal: the pattern's mean, which is then not (0, 0, sin a). A tile whose two tables are one is *face-shaded*: it
/// has normals for its squares alone, with coarser tables.

#include "database/model/visual_database.h"

namespace linkdig {

/// Bounds on what a repeated tile may ask of the machine, for the compiler and for the reader of compiled databases.
inline constexpr double least_cell_m = 0.01;
inline constexpr double max_tile_reach_m = 1e9; ///< from the eye to the outermost ring's border
inline constexpr std::uint32_t max_half_width = 256;
inline constexpr std::uint64_t max_tile_squares =
    4'000'000; ///< that the machine makes each frame, of all tiles

/// Normals of a table with its coarser ones: period^2 + (period/2)^2 + ... + 1.
constexpr std::uint64_t with_coarser_size(std::uint32_t period) {
    return (4 * std::uint64_t{period} * period - 1) / 3;
}

constexpr bool is_face_shaded(const RepeatedTile& tile) {
    return tile.first_normal == tile.first_face_normal;
}

constexpr bool has_coarser_tables(const RepeatedTile& tile) {
    return is_face_shaded(tile) ||
           std::uint64_t{tile.first_face_normal} == tile.first_normal + with_coarser_size(tile.period);
}

/// Normals in each of the tile's tables.
constexpr std::uint64_t tile_table_size(const RepeatedTile& tile) {
    return has_coarser_tables(tile) ? with_coarser_size(tile.period)
                                    : std::uint64_t{tile.period} * tile.period;
}

} // namespace linkdig
