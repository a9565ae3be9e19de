#include "database/compiler/read_tiles.h"

#include "database/compiler/tile_pattern.h"
#include "database/model/tile_tables.h"

#include <fmt/format.h>

#include <algorithm>

namespace linkdig::database {

namespace {

std::uint32_t read_whole(TableReader& reader, const char* key, std::int64_t least, std::int64_t greatest) {
    return static_cast<std::uint32_t>(reader.integer(key, least, greatest));
}

void check_list(TableReader& reader, std::uint32_t list, const std::vector<ModelObject>& objects,
                const Tiles& before, const Reading& reading) {
    const ObjectList& of = reading.registry->lists[list].list;
    if (of.attachment != Attachment::world)
        reader.error_at(
            "list",
            fmt::format("the list \"{}\" of a tile does not stand in the world; expected frame = \"world\"",
                        of.name));
    for (const RepeatedTile& other : before.tiles)
        if (other.list == list)
            reader.error_at("list", fmt::format("the list \"{}\" has a tile already; expected one", of.name));
    for (const ModelObject& object : objects) {
        if (!object.resolved || object.list != list) continue;
        reader.error_at(
            "list", fmt::format("the list \"{}\" of a tile holds the object \"{}\"; expected nothing else",
                                of.name, object.name));
        return;
    }
}

std::uint32_t add_normals(const std::vector<Vec3f>& table, Tiles& result) {
    const auto first = static_cast<std::uint32_t>(result.normals.size());
    result.normals.insert(result.normals.end(), table.begin(), table.end());
    return first;
}

void read_tile(AuthoredTable table, const std::vector<ModelObject>& objects, const Reading& reading,
               Tiles& result) {
    TableReader reader = reader_of(table, *reading.sources, "tile", *reading.diagnostics);
    RepeatedTile tile;
    const auto list = named(reader, "list", reading.registry->list_names, true);
    tile.list = list.value_or(0);
    if (list) check_list(reader, *list, objects, result, reading);
    tile.period = read_whole(reader, "period", 2, 1024);
    if ((tile.period & (tile.period - 1)) != 0)
        reader.error_at("period",
                        fmt::format("\"period\" is {}; expected a power of two, 2 to 1024", tile.period));
    tile.cell_m = reader.length_m("cell", {}, {least_cell_m, 1e5});
    tile.rings = read_whole(reader, "rings", 1, 16);
    tile.fine_levels = read_whole(reader, "fine_levels", 0, 6);
    tile.half_width = read_whole(reader, "half_width", 8, max_half_width);
    if (tile.half_width % 4 != 0)
        reader.error_at("half_width", fmt::format("\"half_width\" is {}; expected a multiple of 4, 8 to {}",
                                                  tile.half_width, max_half_width));
    tile.colour =
        static_cast<std::uint16_t>(named(reader, "colour", reading.registry->colour_names, true).value_or(0));
    const bool face_shaded = reader.choice("shading", 0, {"vertex", "face"}) == 1;
    const TilePattern pattern = read_pattern(reader, tile, face_shaded);
    if (tile.cell_m * static_cast<double>(1U << tile.rings) * tile.half_width > max_tile_reach_m)
        reader.error_at("rings",
                        fmt::format("the rings reach further than {:.0f} m; expected fewer or smaller ones",
                                    max_tile_reach_m));
    tile.file = table.file;
    tile.line = place_of(*table.table, table.file).line;
    reader.finish();
    if (!face_shaded) tile.first_normal = add_normals(pattern.vertices, result);
    tile.first_face_normal = add_normals(pattern.faces, result);
    if (face_shaded) tile.first_normal = tile.first_face_normal;
    result.tiles.push_back(tile);
}

} // namespace

Tiles read_tiles(const AuthoredTables& tables, const std::vector<ModelObject>& objects,
                 const Reading& reading) {
    Tiles result;
    for (const AuthoredTable each : tables.tiles)
        read_tile(each, objects, reading, result);
    std::uint64_t squares = 0;
    for (const RepeatedTile& tile : result.tiles)
        squares += 4ULL * tile.half_width * tile.half_width * (tile.rings + tile.fine_levels + 1ULL);
    if (squares > max_tile_squares)
        reading.error(
            place_of(*tables.tiles.back().table, tables.tiles.back().file),
            fmt::format("the tiles make {} squares a frame; expected at most {}", squares, max_tile_squares));
    return result;
}

} // namespace linkdig::database
