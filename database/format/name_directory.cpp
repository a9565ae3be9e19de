#include "database/format/name_directory.h"

#include <algorithm>

namespace linkdig::database {

namespace {

const std::string& name_of(const std::string& name) { return name; }
template <typename Named>
const std::string& name_of(const Named& named) {
    return named.name;
}

template <typename Named>
std::optional<std::uint32_t> find(const std::vector<Named>& things, std::string_view name) {
    const auto found =
        std::ranges::find_if(things, [&](const Named& thing) { return name_of(thing) == name; });
    if (found == things.end()) return std::nullopt;
    return static_cast<std::uint32_t>(found - things.begin());
}

} // namespace

std::optional<std::uint32_t> NameDirectory::find_sun(std::string_view name) const { return find(suns, name); }

std::optional<std::uint32_t> NameDirectory::find_moving_object(std::string_view name) const {
    return find(moving_objects, name);
}

std::optional<std::uint32_t> NameDirectory::find_slot(std::string_view name) const {
    return find(slots, name);
}

std::optional<std::uint32_t> NameDirectory::find_list(std::string_view name) const {
    return find(lists, name);
}

std::optional<std::uint32_t> NameDirectory::find_colour(std::string_view name) const {
    return find(colours, name);
}

std::optional<std::uint32_t> NameDirectory::find_cluster(std::string_view name) const {
    return find(clusters, name);
}

NameDirectory name_directory(const VisualDatabase& database, std::uint64_t id) {
    NameDirectory directory;
    directory.database_name = database.name;
    directory.database_id = id;
    directory.suns = database.suns;
    directory.moving_objects = database.moving_objects;
    directory.colours = database.colour_names;
    directory.colour_codes = database.colours;
    for (const SubstitutionSlot& slot : database.slots)
        directory.slots.push_back({slot.name, slot.alternatives});
    for (const ObjectList& list : database.lists)
        directory.lists.push_back({list.name, list.sun, list.ambient, list.diffuse});
    for (const Cluster& cluster : database.clusters)
        directory.clusters.push_back(cluster.name);
    return directory;
}

} // namespace linkdig::database
