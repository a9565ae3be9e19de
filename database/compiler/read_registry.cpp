#include "database/compiler/registry.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace linkdig::database {

namespace {

constexpr std::size_t longest_name = 1000;

/// Reports a place of a frame that lies beyond 10,000 km.
void check_reach(TableReader& reader, const char* key, const Vec3d& point) {
    constexpr double farthest_m = 1e7;
    const Vec3d size = glm::abs(point);
    if (std::max({size.x, size.y, size.z}) > farthest_m)
        reader.error_at(key, fmt::format("\"{}\" lies beyond {:.0f} m; expected less", key, farthest_m));
}

} // namespace

void NameTable::add(std::string name, Place at, const Sources& sources, Diagnostics& diagnostics) {
    if (name.size() > longest_name)
        diagnostics.error(sources.location(at),
                          fmt::format("the name of a {} has {} bytes; expected at most {}", kind_,
                                      name.size(), longest_name));
    if (!name.empty()) {
        const auto [found, is_new] = index_.emplace(name, size());
        if (!is_new) {
            const Place first = places_[found->second];
            diagnostics.error(sources.location(at),
                              fmt::format("the {} \"{}\" stands already in {}:{}; expected another name",
                                          kind_, name, sources.files[first.file].path, first.line));
        }
    }
    names_.push_back(std::move(name));
    places_.push_back(at);
}

std::optional<std::uint32_t> NameTable::find(std::string_view name) const {
    const auto found = index_.find(name);
    return found == index_.end() ? std::nullopt : std::optional(found->second);
}

std::string NameTable::table() const {
    std::string table = kind_;
    std::replace(table.begin(), table.end(), ' ', '_');
    return fmt::format("[[{}]]", table);
}

std::string NameTable::reference() const { return "name of a " + table(); }

std::string NameTable::unknown(std::string_view name) const {
    const std::string closest = suggestion(name, names_);
    return fmt::format("no {} is named \"{}\"; {}", kind_, name,
                       closest.empty() ? fmt::format("expected a {} of that name", table())
                                       : fmt::format("did you mean {}?", closest));
}

std::optional<std::uint32_t> named(TableReader& reader, std::string_view key, const NameTable& names,
                                   bool required) {
    reader.describe(key, names.reference(), required ? std::nullopt : std::optional<std::string>("none"));
    if (!reader.has(key) && !required) {
        reader.node(key);
        return std::nullopt;
    }
    const std::string name = reader.text(key);
    if (name.empty()) return std::nullopt;
    const std::optional<std::uint32_t> found = names.find(name);
    if (!found) reader.error_at(key, names.unknown(name));
    return found;
}

Vec3d read_rgb(TableReader& reader, std::string_view key) {
    reader.describe(key, "[red, green, blue], whole numbers 0 to 255", {});
    const Vec3d rgb = reader.vector(key);
    for (int i = 0; i < 3; ++i) {
        if (rgb[i] >= 0 && rgb[i] <= 255 && std::floor(rgb[i]) == rgb[i]) continue;
        reader.error_at(key, fmt::format("\"{}\" holds {}; expected whole numbers 0 to 255", key, rgb[i]));
        return Vec3d(0.0);
    }
    return rgb;
}

namespace {

class RegistryReader {
public:
    RegistryReader(const Sources& sources, Diagnostics& diagnostics)
        : sources_(&sources), diagnostics_(&diagnostics) {}

    void read(const AuthoredTables& tables) {
        read_database(tables);
        for (const AuthoredTable each : tables.colours)
            read_colour(each);
        for (const AuthoredTable each : tables.suns)
            read_name(each, "sun", registry.suns);
        for (const AuthoredTable each : tables.moving_objects)
            read_name(each, "moving_object", registry.moving_objects);
        for (const AuthoredTable each : tables.slots)
            read_slot(each);
        for (const AuthoredTable each : tables.clusters)
            read_cluster(each);
        for (const AuthoredTable each : tables.lists)
            read_list(each);
        resolve_added_lists();
        if (registry.colours.size() > std::numeric_limits<std::uint16_t>::max())
            diagnostics_->error(
                sources_->location(place_of(*tables.colours.back().table, tables.colours.back().file)),
                "more than 65535 colours; expected fewer");
    }

    Registry registry;

private:
    TableReader reader(AuthoredTable table, const char* kind) {
        return reader_of(table, *sources_, kind, *diagnostics_);
    }
    void add_name(TableReader& reader, AuthoredTable table, NameTable& names) {
        names.add(reader.text("name"), place_of(*table.table, table.file), *sources_, *diagnostics_);
    }

    /// 0 where there is none.
    static std::uint32_t read_edge_budget(TableReader& reader) {
        reader.describe("edge_budget", "whole number, 1 to 1000000000", "none");
        return static_cast<std::uint32_t>(reader.integer("edge_budget", 0, 1, 1000000000));
    }

    void read_database(const AuthoredTables& tables) {
        if (!tables.database) return;
        TableReader reader(*tables.database->table, sources_->files[tables.database->file].path, "[database]",
                           *diagnostics_);
        registry.name = reader.text("name");
        registry.edge_budget = read_edge_budget(reader);
        registry.edge_budget_at = place_of(*tables.database->table, tables.database->file);
        reader.finish();
    }

    void read_name(AuthoredTable table, const char* kind, NameTable& names) {
        TableReader each = reader(table, kind);
        add_name(each, table, names);
        each.finish();
    }

    void read_colour(AuthoredTable table) {
        TableReader each = reader(table, "colour");
        add_name(each, table, registry.colour_names);
        const Vec3d rgb = read_rgb(each, "rgb");
        const auto component = [&](int i) { return static_cast<std::uint8_t>(rgb[i]); };
        registry.colours.push_back({component(0), component(1), component(2), 0});
        each.finish();
    }

    void read_slot(AuthoredTable table) {
        TableReader each = reader(table, "slot");
        add_name(each, table, registry.slots);
        const bool first_empty = each.boolean("first_empty", false);
        registry.alternatives.push_back(
            static_cast<std::uint32_t>(each.integer("alternatives", first_empty ? 2 : 1, most_alternatives)));
        registry.first_objects.push_back(first_empty ? 1 : 0);
        registry.slot_places.push_back(place_of(*table.table, table.file));
        each.finish();
    }

    static std::optional<Vec3d> optional_point(TableReader& reader, const char* stem) {
        const bool present = reader.has(std::string(stem) + "_m") || reader.has(std::string(stem) + "_ft");
        reader.describe(std::string(stem) + "_m", fmt::format("[x, y, z]; or `{}_ft`", stem),
                        "from its contents");
        const Vec3d point = reader.point_m(stem, Vec3d(0.0));
        return present ? std::optional(point) : std::nullopt;
    }

    void read_cluster(AuthoredTable table) {
        TableReader each = reader(table, "cluster");
        add_name(each, table, registry.cluster_names);
        AuthoredCluster cluster;
        cluster.group_number = static_cast<std::int32_t>(each.integer("priority", -1000000, 1000000));
        if (const auto moving = named(each, "moving_object", registry.moving_objects, false))
            cluster.moving_object = static_cast<std::int32_t>(*moving);
        cluster.reference_m = optional_point(each, "reference");
        cluster.half_extent_m = optional_point(each, "half_extent");
        if (cluster.half_extent_m &&
            std::min({cluster.half_extent_m->x, cluster.half_extent_m->y, cluster.half_extent_m->z}) < 0)
            each.error_at("half_extent_m", "\"half_extent_m\" holds a negative length; expected at least 0");
        check_reach(each, "reference_m", cluster.reference_m.value_or(Vec3d(0.0)));
        check_reach(each, "half_extent_m", cluster.half_extent_m.value_or(Vec3d(0.0)));
        cluster.at = place_of(*table.table, table.file);
        registry.clusters.push_back(cluster);
        each.finish();
    }

    void read_list(AuthoredTable table) {
        TableReader each = reader(table, "object_list");
        add_name(each, table, registry.list_names);
        AuthoredList entry;
        entry.at = place_of(*table.table, table.file);
        entry.list.name = registry.list_names.names().back();
        each.describe("added_to", registry.list_names.reference(), "none");
        each.describe("frame", R"("world" or "body" or "waterline" or "eye")",
                      R"("body" in a moving cluster, else "world")");
        const auto cluster = named(each, "cluster", registry.cluster_names, true);
        const auto sun = named(each, "sun", registry.suns, true);
        entry.in_cluster = cluster.has_value();
        entry.resolved = cluster && sun;
        entry.list.cluster = cluster.value_or(0);
        entry.list.sun = sun.value_or(0);
        entry.list.number = static_cast<std::int32_t>(each.integer("priority", 0, -1000000, 1000000));
        entry.list.ambient = static_cast<float>(each.number("ambient", 0.3, {0, 1}));
        entry.list.diffuse = static_cast<float>(each.number("diffuse", 0.7, {0, 1}));
        entry.list.origin_m = each.point_m("origin", Vec3d(0.0));
        check_reach(each, "origin_m", entry.list.origin_m);
        entry.edge_budget = read_edge_budget(each);
        read_attachment(each, entry);
        entry.added_to = each.text("added_to", "");
        entry.added_to_at = each.at("added_to");
        registry.lists.push_back(entry);
        each.finish();
    }

    /// Lists may be named before they stand in a file, so names are looked up when all are known.
    void resolve_added_lists() {
        for (std::size_t i = 0; i < registry.lists.size(); ++i) {
            AuthoredList& entry = registry.lists[i];
            if (entry.added_to.empty()) continue;
            const auto found = registry.list_names.find(entry.added_to);
            if (!found) {
                diagnostics_->error(entry.added_to_at, registry.list_names.unknown(entry.added_to));
            } else if (*found == i) {
                diagnostics_->error(entry.added_to_at, "a list is added to itself; expected another list");
            } else {
                entry.list.added_to = static_cast<std::int32_t>(*found);
            }
        }
    }

    /// A moving cluster's lists hang in its body unless they say otherwise.
    void read_attachment(TableReader& reader, AuthoredList& entry) {
        const bool known = entry.in_cluster;
        const bool moving = known && registry.clusters[entry.list.cluster].moving_object != none;
        const auto fallback = moving ? Attachment::body : Attachment::world;
        entry.list.attachment = static_cast<Attachment>(reader.choice(
            "frame", static_cast<std::size_t>(fallback), {"world", "body", "waterline", "eye"}));
        const bool needs_mover =
            entry.list.attachment == Attachment::body || entry.list.attachment == Attachment::waterline;
        if (known && needs_mover && !moving)
            reader.error_at("frame",
                            fmt::format("\"frame\" needs a moving object, but the cluster \"{}\" is static; "
                                        "expected \"world\" or \"eye\"",
                                        registry.cluster_names.names()[entry.list.cluster]));
    }

    const Sources* sources_;
    Diagnostics* diagnostics_;
};

} // namespace

Registry read_registry(const AuthoredTables& tables, const Sources& sources, Diagnostics& diagnostics) {
    RegistryReader reader(sources, diagnostics);
    reader.read(tables);
    read_details(tables, sources, diagnostics, reader.registry);
    return std::move(reader.registry);
}

} // namespace linkdig::database
