// Levels of detail: the ranges of each thing that is replaced by range.

#include "database/compiler/registry.h"

#include <fmt/format.h>

#include <algorithm>

namespace linkdig::database {

namespace {

constexpr std::size_t most_levels = 16;
constexpr double farthest_m = 1e7;

/// The array of ranges under to_m or to_ft. A mistake is reported, and nothing returned.
std::vector<double> read_ranges_m(TableReader& reader) {
    const bool feet = reader.has("to_ft") && !reader.has("to_m");
    reader.describe("to_m", fmt::format("array of numbers, 1 to {} of them; or `to_ft`", most_levels), {});
    const char* key = feet ? "to_ft" : "to_m";
    const double unit = feet ? 0.3048 : 1.0;
    const toml::node* node = reader.node(key);
    const toml::array* array = node == nullptr ? nullptr : node->as_array();
    std::vector<double> ranges;
    for (std::size_t i = 0; array != nullptr && i < array->size(); ++i) {
        const toml::node& each = *array->get(i);
        const auto value = each.is_number() ? each.value<double>() : std::nullopt;
        if (!value || !(*value > 0 && *value * unit <= farthest_m)) {
            array = nullptr;
            break;
        }
        ranges.push_back(*value * unit);
    }
    if (array != nullptr && !ranges.empty() && ranges.size() <= most_levels) return ranges;
    reader.error_at(
        key, fmt::format("\"{}\" lists no ranges; expected 1 to {} lengths above 0 and at most {:.0f} m, "
                         "level 0 first",
                         key, most_levels, farthest_m));
    return {};
}

/// Every level is present somewhere, and no more than two at a time.
void check_ranges(TableReader& reader, const AuthoredDetail& detail) {
    const double apart = std::max(detail.detail.hysteresis_m, detail.detail.blend_m);
    double inner = -0.5 * apart;
    for (std::size_t k = 0; k < detail.to_m.size(); ++k) {
        const double to = static_cast<double>(detail.to_m[k]);
        const char* key = reader.has("to_m") ? "to_m" : "to_ft";
        if (to <= inner)
            reader.error_at(
                key, fmt::format("level {} reaches to {:.6g} m and the one before to {:.6g} m: it is never "
                                 "seen; expected ascending ranges",
                                 k, to, inner));
        else if (to < inner + apart)
            reader.error_at(
                key,
                fmt::format("level {} ends at {:.6g} m, where the change before it is not over: blend_m or "
                            "hysteresis_m is {:.6g} m; expected deeper levels",
                            k, to, apart));
        inner = to;
    }
}

AuthoredDetail read_detail(AuthoredTable table, TableReader& reader, const Registry& registry) {
    AuthoredDetail made;
    made.at = place_of(*table.table, table.file);
    const auto cluster = named(reader, "cluster", registry.cluster_names, true);
    made.resolved = cluster.has_value();
    made.detail.cluster = cluster.value_or(0);
    made.detail.reference_m = reader.point_m("reference");
    const Vec3d size = glm::abs(made.detail.reference_m);
    if (std::max({size.x, size.y, size.z}) > farthest_m)
        reader.error_at("reference_m",
                        fmt::format("\"reference_m\" lies beyond {:.0f} m; expected less", farthest_m));
    made.detail.hysteresis_m = static_cast<float>(reader.length_m("hysteresis", 0.0, {0, farthest_m}));
    made.detail.blend_m = static_cast<float>(reader.length_m("blend", 0.0, {0, farthest_m}));
    made.detail.added = reader.boolean("added", false) ? 1 : 0;
    if (made.detail.hysteresis_m > 0 && made.detail.blend_m > 0)
        reader.error_at("hysteresis_m",
                        "\"hysteresis_m\" stands beside \"blend_m\"; expected one: a blend shows no "
                        "change that could be seen twice");
    for (const double range_m : read_ranges_m(reader))
        made.to_m.push_back(static_cast<float>(range_m));
    check_ranges(reader, made);
    return made;
}

} // namespace

void read_details(const AuthoredTables& tables, const Sources& sources, Diagnostics& diagnostics,
                  Registry& registry) {
    std::uint32_t levels = 0;
    for (const AuthoredTable each : tables.details) {
        TableReader reader = reader_of(each, sources, "detail", diagnostics);
        registry.details.add(reader.text("name"), place_of(*each.table, each.file), sources, diagnostics);
        AuthoredDetail made = read_detail(each, reader, registry);
        made.detail.name = registry.details.names().back();
        made.detail.first_level = levels;
        made.detail.levels = static_cast<std::uint32_t>(made.to_m.size());
        levels += made.detail.levels;
        registry.authored_details.push_back(std::move(made));
        reader.finish();
    }
}

} // namespace linkdig::database
