#include "database/format/name_directory.h"

#include <algorithm>
#include <utility>

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

struct Bounds {
    Vec3d least{1e30};
    Vec3d greatest{-1e30};
    void take(const Vec3d& point) {
        least = glm::min(least, point);
        greatest = glm::max(greatest, point);
    }
};

/// Of every cluster, from the faces that hang in the world or in a body's frame.
std::vector<Bounds> rigid_bounds(const VisualDatabase& database) {
    std::vector<Bounds> bounds(database.clusters.size());
    for (const Face& face : database.faces) {
        const ObjectList& list = database.lists[database.objects[face.object].list];
        if (list.attachment != Attachment::world && list.attachment != Attachment::body) continue;
        for (std::uint32_t c = face.first_corner; c < face.first_corner + face.corner_count; ++c) {
            const Vec4f& position = database.vertices[database.corners[c]].position;
            if (position.w != 0.0F) bounds[list.cluster].take(list.origin_m + Vec3d(Vec3f(position)));
        }
    }
    return bounds;
}

std::vector<NameDirectory::Cluster> clusters_of(const VisualDatabase& database) {
    const std::vector<Bounds> bounds = rigid_bounds(database);
    std::vector<NameDirectory::Cluster> clusters;
    for (std::size_t c = 0; c < database.clusters.size(); ++c) {
        const Cluster& cluster = database.clusters[c];
        NameDirectory::Cluster named{cluster.name, database.groups[cluster.group].number,
                                     cluster.moving_object};
        if (bounds[c].least.x <= bounds[c].greatest.x) {
            named.middle_m = (bounds[c].least + bounds[c].greatest) / 2.0;
            named.half_m = (bounds[c].greatest - bounds[c].least) / 2.0;
        }
        clusters.push_back(std::move(named));
    }
    return clusters;
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
    directory.clusters = clusters_of(database);
    for (const RepeatedTile& tile : database.tiles) {
        const auto first = database.tile_normals.begin() + tile.first_normal;
        directory.tiles.push_back({tile.list, {first, first + std::ptrdiff_t{tile.period} * tile.period}});
    }
    return directory;
}

} // namespace linkdig::database
