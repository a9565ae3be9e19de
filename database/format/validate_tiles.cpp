// Repeated tiles: their parameters decide how many faces the machine makes each frame.

#include "database/format/validate.h"
#include "database/format/validate_parts.h"

#include "database/model/mathematics.h"
#include "database/model/tile_tables.h"

#include <bit>

namespace linkdig::database {

namespace {

std::string check_parameters(const RepeatedTile& tile) {
    if (!std::has_single_bit(tile.period) || tile.period < 2 || tile.period > 1024)
        return fmt::format("period is {}; expected a power of two from 2 to 1024", tile.period);
    if (tile.rings < 1 || tile.rings > 16) return fmt::format("rings is {}; expected 1 to 16", tile.rings);
    if (tile.fine_levels > 6) return fmt::format("fine_levels is {}; expected 0 to 6", tile.fine_levels);
    if (tile.half_width % 4 != 0 || tile.half_width < 8 || tile.half_width > max_half_width)
        return fmt::format("half_width is {}; expected a multiple of 4 from 8 to {}", tile.half_width,
                           max_half_width);
    const double reach_m = tile.cell_m * static_cast<double>(1U << tile.rings) * tile.half_width;
    if (!(tile.cell_m >= least_cell_m) || !within(reach_m, 0.0, max_tile_reach_m))
        return fmt::format("cell_m is {}; expected {} at least, and rings that reach no further than {} m",
                           tile.cell_m, least_cell_m, max_tile_reach_m);
    if (!within(tile.vertical_angle_rad, 0.0, static_cast<double>(static_cast<float>(pi / 2.0))))
        return fmt::format("vertical_angle_rad is {}; expected 0 to pi/2", tile.vertical_angle_rad);
    return {};
}

std::string check_indices(const VisualDatabase& database, std::size_t i) {
    const RepeatedTile& tile = database.tiles[i];
    const std::uint64_t cells = tile_table_size(tile);
    const std::size_t normals = database.tile_normals.size();
    if (!span_fits(tile.first_normal, cells, normals))
        return out_of_range("tiles", i, "first_normal", tile.first_normal, normals, "tile_normals");
    if (!span_fits(tile.first_face_normal, cells, normals))
        return out_of_range("tiles", i, "first_face_normal", tile.first_face_normal, normals, "tile_normals");
    if (tile.colour >= database.colours.size())
        return out_of_range("tiles", i, "colour", tile.colour, database.colours.size(), "colours");
    const bool generated = database.source_files.empty() && tile.file == 0 && tile.line == 0;
    if (!generated && tile.file >= database.source_files.size())
        return out_of_range("tiles", i, "file", tile.file, database.source_files.size(), "source_files");
    if (tile.list >= database.lists.size())
        return out_of_range("tiles", i, "list", tile.list, database.lists.size(), "lists");
    const ObjectList& list = database.lists[tile.list];
    if (list.tile != static_cast<std::int32_t>(i))
        return wrong("tiles", i, fmt::format("list is {}, whose own tile is {}", tile.list, list.tile));
    if (list.root != none)
        return wrong("tiles", i, fmt::format("list is {}, which has faces of its own", tile.list));
    return {};
}

} // namespace

std::string check_tiles(const VisualDatabase& database) {
    std::uint64_t squares = 0;
    for (std::size_t i = 0; i < database.tiles.size(); ++i) {
        const RepeatedTile& tile = database.tiles[i];
        if (const std::string reason = check_parameters(tile); !reason.empty())
            return wrong("tiles", i, reason);
        if (std::string reason = check_indices(database, i); !reason.empty()) return reason;
        squares += 4ULL * tile.half_width * tile.half_width * (tile.rings + tile.fine_levels + 1ULL);
    }
    if (squares > max_tile_squares)
        return fmt::format("tiles make {} squares a frame; at most {} are allowed", squares,
                           max_tile_squares);
    for (std::size_t i = 0; i < database.lists.size(); ++i) {
        const std::int32_t tile = database.lists[i].tile;
        if (tile != none && database.tiles[static_cast<std::size_t>(tile)].list != i)
            return wrong("lists", i, fmt::format("tile is {}, which belongs to another list", tile));
    }
    for (std::size_t i = 0; i < database.tile_normals.size(); ++i)
        if (!within(length_of(database.tile_normals[i]), 0.0, 1.0 + unit_tolerance))
            return fmt::format("tile_normals[{}] is longer than a unit vector", i);
    return {};
}

} // namespace linkdig::database
