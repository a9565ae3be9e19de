// Names, and the records that own others: slots, groups, clusters, lists, objects.

#include "database/format/validate.h"
#include "database/format/validate_parts.h"

#include <algorithm>

namespace linkdig::database {

namespace {

/// Names end up in terminals and messages; control characters would speak to the terminal.
std::string check_text(std::string_view what, const std::string& name) {
    if (name.size() > max_name_bytes)
        return fmt::format("{} is {} bytes long; at most {} are allowed", what, name.size(), max_name_bytes);
    const auto control = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; };
    if (std::ranges::any_of(name, control)) return fmt::format("{} holds control characters", what);
    return {};
}

std::string check_texts(std::string_view what, const std::vector<std::string>& names) {
    for (std::size_t i = 0; i < names.size(); ++i)
        if (std::string reason = check_text("", names[i]); !reason.empty())
            return fmt::format("{}[{}]{}", what, i, reason);
    return {};
}

/// Names that a host looks things up by.
std::string check_unique(std::string_view what, const std::vector<std::string>& names) {
    if (std::string reason = check_texts(what, names); !reason.empty()) return reason;
    std::vector<std::string_view> sorted(names.begin(), names.end());
    std::ranges::sort(sorted);
    if (!sorted.empty() && sorted.front().empty()) return fmt::format("one of {} has no name", what);
    const auto twice = std::ranges::adjacent_find(sorted);
    return twice == sorted.end() ? std::string{} : fmt::format("two of {} are named \"{}\"", what, *twice);
}

template <typename Record>
std::vector<std::string> names_of(const std::vector<Record>& records) {
    std::vector<std::string> names;
    names.reserve(records.size());
    for (const Record& record : records)
        names.push_back(record.name);
    return names;
}

std::string check_groups(const VisualDatabase& database) {
    const auto& groups = database.groups;
    for (std::size_t i = 1; i < groups.size(); ++i)
        if (groups[i - 1].number >= groups[i].number)
            return wrong("groups", i,
                         fmt::format("number is {} after {}; expected ascending numbers", groups[i].number,
                                     groups[i - 1].number));
    return {};
}

std::string check_clusters(const VisualDatabase& database) {
    for (std::size_t i = 0; i < database.clusters.size(); ++i) {
        const Cluster& cluster = database.clusters[i];
        if (cluster.group >= database.groups.size())
            return out_of_range("clusters", i, "group", cluster.group, database.groups.size(), "groups");
        if (!none_or_below(cluster.moving_object, database.moving_objects.size()))
            return out_of_range("clusters", i, "moving_object", cluster.moving_object,
                                database.moving_objects.size(), "moving_objects");
        if (!all_within(cluster.reference_point_m, -max_coordinate_m, max_coordinate_m))
            return wrong("clusters", i, "reference_point_m is not finite, or beyond 1e7 m");
        if (!all_within(cluster.half_extent_m, 0.0, 4 * max_coordinate_m))
            return wrong("clusters", i, "half_extent_m is negative, not finite, or beyond 4e7 m");
    }
    return {};
}

std::string check_lists(const VisualDatabase& database) {
    for (std::size_t i = 0; i < database.lists.size(); ++i) {
        const ObjectList& list = database.lists[i];
        if (list.cluster >= database.clusters.size())
            return out_of_range("lists", i, "cluster", list.cluster, database.clusters.size(), "clusters");
        if (list.sun >= database.suns.size())
            return out_of_range("lists", i, "sun", list.sun, database.suns.size(), "suns");
        if (list.attachment > Attachment::eye)
            return wrong("lists", i, "attachment is none of world, body, waterline, eye");
        if (!within(list.ambient, 0.0, 1.0)) return wrong("lists", i, "ambient is not in 0 to 1");
        if (!within(list.diffuse, 0.0, 1.0)) return wrong("lists", i, "diffuse is not in 0 to 1");
        if (!all_within(list.origin_m, -max_coordinate_m, max_coordinate_m))
            return wrong("lists", i, "origin_m is not finite, or beyond 1e7 m");
        if (!none_or_below(list.tile, database.tiles.size()))
            return out_of_range("lists", i, "tile", list.tile, database.tiles.size(), "tiles");
        if (!none_or_below(list.added_to, database.lists.size()))
            return out_of_range("lists", i, "added_to", list.added_to, database.lists.size(), "lists");
        if (list.added_to == static_cast<std::int32_t>(i))
            return wrong("lists", i, "added_to is the list itself");
    }
    return {};
}

std::string check_objects(const VisualDatabase& database) {
    for (std::size_t i = 0; i < database.objects.size(); ++i) {
        const Object& object = database.objects[i];
        if (object.list >= database.lists.size())
            return out_of_range("objects", i, "list", object.list, database.lists.size(), "lists");
        if (!none_or_below(object.slot, database.slots.size()))
            return out_of_range("objects", i, "slot", object.slot, database.slots.size(), "slots");
        if (object.slot != none &&
            object.alternative >= database.slots[static_cast<std::size_t>(object.slot)].alternatives)
            return wrong("objects", i,
                         fmt::format("alternative is {}, beyond its slot's", object.alternative));
        if (object.reserved != 0) return wrong("objects", i, "reserved is not zero");
        if (!none_or_below(object.level, database.detail_levels.size()))
            return out_of_range("objects", i, "level", object.level, database.detail_levels.size(),
                                "detail_levels");
    }
    return {};
}

std::string check_slots(const VisualDatabase& database) {
    for (std::size_t i = 0; i < database.slots.size(); ++i)
        if (database.slots[i].alternatives < 1 || database.slots[i].alternatives > max_alternatives)
            return wrong("slots", i,
                         fmt::format("alternatives is {}; expected 1 to {}", database.slots[i].alternatives,
                                     max_alternatives));
    for (std::size_t i = 0; i < database.colours.size(); ++i)
        if (database.colours[i].reserved != 0) return wrong("colours", i, "reserved is not zero");
    return {};
}

} // namespace

std::string check_names(const VisualDatabase& database) {
    if (database.colour_names.size() != database.colours.size())
        return fmt::format("there are {} colours, but {} colour_names", database.colours.size(),
                           database.colour_names.size());
    std::string reason = check_text("name", database.name);
    for (const auto& [what, names] :
         {std::pair{"source_files", database.source_files}, std::pair{"objects", names_of(database.objects)}})
        if (reason.empty()) reason = check_texts(what, names);
    for (const auto& [what, names] :
         {std::pair{"colour_names", database.colour_names}, std::pair{"suns", database.suns},
          std::pair{"moving_objects", database.moving_objects}, std::pair{"slots", names_of(database.slots)},
          std::pair{"details", names_of(database.details)},
          std::pair{"clusters", names_of(database.clusters)}, std::pair{"lists", names_of(database.lists)}})
        if (reason.empty()) reason = check_unique(what, names);
    return reason;
}

std::string check_owners(const VisualDatabase& database) {
    std::string reason;
    for (const auto& check : {check_slots, check_groups, check_clusters, check_lists, check_objects})
        if (reason.empty()) reason = check(database);
    return reason;
}

} // namespace linkdig::database
