#include "database/format/dump.h"

#include "database/format/summary.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <array>
#include <charconv>
#include <iterator>

namespace linkdig::database {

namespace {

using Json = nlohmann::ordered_json;

const char* name_of(Attachment attachment) {
    constexpr std::array names = {"world", "body", "waterline", "eye"};
    return names[static_cast<std::size_t>(attachment)];
}

/// The shortest decimal number that is read back as this float, not the longer one of its value as a double.
double short_decimal(float value) {
    char digits[32];
    const auto written = std::to_chars(digits, digits + sizeof(digits), value);
    double decimal = 0.0;
    std::from_chars(digits, written.ptr, decimal);
    return decimal;
}
double short_decimal(double value) { return value; }

template <typename Vector>
Json triple(const Vector& v) {
    return Json::array({short_decimal(v.x), short_decimal(v.y), short_decimal(v.z)});
}

template <typename Name>
Json or_null(std::int32_t index, Name&& name) {
    return index == none ? Json(nullptr) : Json(name(static_cast<std::size_t>(index)));
}

Json totals_json(const VisualDatabase& d) {
    return {{"colours", d.colours.size()},
            {"suns", d.suns.size()},
            {"moving_objects", d.moving_objects.size()},
            {"slots", d.slots.size()},
            {"details", d.details.size()},
            {"groups", d.groups.size()},
            {"clusters", d.clusters.size()},
            {"lists", d.lists.size()},
            {"objects", d.objects.size()},
            {"planes", d.planes.size()},
            {"run_leaves", d.run_leaves.size()},
            {"runs", d.runs.size()},
            {"faces", d.faces.size()},
            {"corners", d.corners.size()},
            {"vertices", d.vertices.size()},
            {"lights", d.lights.size()},
            {"tiles", d.tiles.size()},
            {"tile_normals", d.tile_normals.size()}};
}

Json object_json(const VisualDatabase& d, const ObjectSummary& counts, std::uint32_t index) {
    const Object& object = d.objects[index];
    Json json = {
        {"name", object.name}, {"faces", counts.faces}, {"corners", counts.corners}, {"edges", counts.edges}};
    if (counts.lights != 0) json["lights"] = counts.lights;
    if (object.slot != none) {
        json["slot"] = d.slots[static_cast<std::size_t>(object.slot)].name;
        json["alternative"] = object.alternative;
    }
    if (object.level != none) {
        const Detail& detail = d.details[d.detail_levels[static_cast<std::size_t>(object.level)].detail];
        json["detail"] = detail.name;
        json["level"] = static_cast<std::uint32_t>(object.level) - detail.first_level;
    }
    return json;
}

Json tile_json(const VisualDatabase& d, const RepeatedTile& tile) {
    return {{"period", tile.period},
            {"cell_m", tile.cell_m},
            {"rings", tile.rings},
            {"fine_levels", tile.fine_levels},
            {"half_width", tile.half_width},
            {"vertical_angle_rad", short_decimal(tile.vertical_angle_rad)},
            {"colour", d.colour_names[tile.colour]}};
}

Json extent_json(const ListSummary& counts) {
    if (!counts.extent) return nullptr;
    return {{"least_m", triple(counts.extent->least)}, {"greatest_m", triple(counts.extent->greatest)}};
}

Json list_json(const VisualDatabase& d, const DatabaseSummary& summary, std::size_t index) {
    const ObjectList& list = d.lists[index];
    const ListSummary& counts = summary.lists[index];
    Json json = {{"name", list.name},
                 {"cluster", d.clusters[list.cluster].name},
                 {"priority", list.number},
                 {"attachment", name_of(list.attachment)},
                 {"sun", d.suns[list.sun]},
                 {"ambient", short_decimal(list.ambient)},
                 {"diffuse", short_decimal(list.diffuse)},
                 {"origin_m", triple(list.origin_m)},
                 {"extent", extent_json(counts)},
                 {"reaches_infinity", counts.reaches_infinity},
                 {"faces", counts.faces},
                 {"smooth_faces", counts.smooth_faces},
                 {"corners", counts.corners},
                 {"lights", counts.lights},
                 {"faces_at_most", counts.faces_at_most},
                 {"edges", counts.edges},
                 {"edges_at_most", counts.edges_at_most},
                 {"runs", counts.runs},
                 {"leaves", counts.leaves},
                 {"planes", counts.planes},
                 {"tree_depth", counts.tree_depth}};
    json["tile"] = or_null(list.tile, [&](std::size_t tile) { return tile_json(d, d.tiles[tile]); });
    Json& objects = json["objects"] = Json::array();
    for (const std::uint32_t object : counts.objects)
        objects.push_back(object_json(d, summary.objects[object], object));
    return json;
}

Json cluster_json(const VisualDatabase& d, const Cluster& cluster) {
    Json json = {{"name", cluster.name}, {"priority", d.groups[cluster.group].number}};
    json["moving_object"] =
        or_null(cluster.moving_object, [&](std::size_t object) { return d.moving_objects[object]; });
    json["reference_point_m"] = triple(cluster.reference_point_m);
    json["half_extent_m"] = triple(cluster.half_extent_m);
    return json;
}

std::string extent_text(const ListSummary& counts) {
    if (!counts.extent) return counts.reaches_infinity ? "at infinity" : "-";
    const Vec3f size = counts.extent->greatest - counts.extent->least;
    return fmt::format("{:.4g} x {:.4g} x {:.4g} m", size.x, size.y, size.z);
}

Json detail_json(const VisualDatabase& d, const DatabaseSummary& summary, const Detail& detail) {
    Json json = {{"name", detail.name},
                 {"cluster", d.clusters[detail.cluster].name},
                 {"reference_m", triple(detail.reference_m)},
                 {"hysteresis_m", short_decimal(detail.hysteresis_m)},
                 {"blend_m", short_decimal(detail.blend_m)},
                 {"added", detail.added != 0}};
    Json& levels = json["levels"] = Json::array();
    for (std::uint32_t k = detail.first_level; k < detail.first_level + detail.levels; ++k)
        levels.push_back({{"to_m", short_decimal(d.detail_levels[k].to_m)},
                          {"objects", summary.levels[k].objects},
                          {"faces", summary.levels[k].faces},
                          {"edges", summary.levels[k].edges}});
    return json;
}

std::string detail_text(const VisualDatabase& d, const DatabaseSummary& summary, const Detail& detail) {
    std::string text = fmt::format("detail {} of {}:", detail.name, d.clusters[detail.cluster].name);
    const auto out = std::back_inserter(text);
    for (std::uint32_t k = detail.first_level; k < detail.first_level + detail.levels; ++k)
        fmt::format_to(out, "{} to {:.6g} m {} faces {} edges", k == detail.first_level ? "" : ",",
                       d.detail_levels[k].to_m, summary.levels[k].faces, summary.levels[k].edges);
    if (detail.blend_m > 0.0F) fmt::format_to(out, "; blend {:.6g} m", detail.blend_m);
    if (detail.hysteresis_m > 0.0F) fmt::format_to(out, "; hysteresis {:.6g} m", detail.hysteresis_m);
    return text + (detail.added != 0 ? "; levels add up\n" : "\n");
}

std::string object_text(const VisualDatabase& d, const ObjectSummary& counts, std::uint32_t index) {
    const Object& object = d.objects[index];
    std::string text = fmt::format("  {:<49} {:>7} {:>8} {:>7}", object.name, counts.faces, "", counts.edges);
    if (object.slot != none)
        text +=
            fmt::format("  {} {}", d.slots[static_cast<std::size_t>(object.slot)].name, object.alternative);
    if (object.level != none) {
        const Detail& detail = d.details[d.detail_levels[static_cast<std::size_t>(object.level)].detail];
        text += fmt::format("  {}, level {}", detail.name,
                            static_cast<std::uint32_t>(object.level) - detail.first_level);
    }
    return text + "\n";
}

} // namespace

std::string dump_json(const VisualDatabase& database, std::uint64_t id) {
    const DatabaseSummary summary = summarise(database);
    Json json = {{"name", database.name}, {"id", fmt::format("{:016x}", id)}};
    json["source_files"] = database.source_files;
    json["totals"] = totals_json(database);
    json["suns"] = database.suns;
    json["moving_objects"] = database.moving_objects;
    Json& slots = json["slots"] = Json::array();
    for (const SubstitutionSlot& slot : database.slots)
        slots.push_back({{"name", slot.name}, {"alternatives", slot.alternatives}});
    Json& details = json["details"] = Json::array();
    for (const Detail& detail : database.details)
        details.push_back(detail_json(database, summary, detail));
    Json& clusters = json["clusters"] = Json::array();
    for (const Cluster& cluster : database.clusters)
        clusters.push_back(cluster_json(database, cluster));
    Json& lists = json["lists"] = Json::array();
    for (std::size_t i = 0; i < database.lists.size(); ++i)
        lists.push_back(list_json(database, summary, i));
    // Names of a foreign file may be no UTF-8.
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string dump_text(const VisualDatabase& database, std::uint64_t id, bool objects) {
    const DatabaseSummary summary = summarise(database);
    std::string text =
        fmt::format("{} (id {:016x}): {} faces, {} vertices, {} light points, {} planes, {} colours\n",
                    database.name, id, database.faces.size(), database.vertices.size(),
                    database.lights.size(), database.planes.size(), database.colours.size());
    const auto out = std::back_inserter(text);
    for (const SubstitutionSlot& slot : database.slots)
        fmt::format_to(out, "slot {}: {} alternatives\n", slot.name, slot.alternatives);
    for (const Detail& detail : database.details)
        text += detail_text(database, summary, detail);
    fmt::format_to(out, "{:<24} {:<16} {:<10} {:>7} {:>8} {:>7} {:>8} {:>7} {:>7} {:>6}  {}\n", "list",
                   "cluster", "frame", "faces", "at most", "edges", "at most", "lights", "planes", "depth",
                   "extent");
    for (std::size_t i = 0; i < database.lists.size(); ++i) {
        const ObjectList& list = database.lists[i];
        const ListSummary& counts = summary.lists[i];
        fmt::format_to(out, "{:<24} {:<16} {:<10} {:>7} {:>8} {:>7} {:>8} {:>7} {:>7} {:>6}  {}\n", list.name,
                       database.clusters[list.cluster].name, name_of(list.attachment), counts.faces,
                       counts.faces_at_most, counts.edges, counts.edges_at_most, counts.lights, counts.planes,
                       counts.tree_depth, list.tile == none ? extent_text(counts) : "tile, to the horizon");
        for (const std::uint32_t object : counts.objects)
            if (objects) text += object_text(database, summary.objects[object], object);
    }
    return text;
}

} // namespace linkdig::database
