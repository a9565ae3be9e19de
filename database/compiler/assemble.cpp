#include "database/compiler/assemble.h"

#include "database/model/most_at_once.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace linkdig::database {

void Box::add(const Vec3d& point) {
    low = any ? glm::min(low, point) : point;
    high = any ? glm::max(high, point) : point;
    any = true;
}

namespace {

std::int32_t moved(std::int32_t reference, std::size_t first_node, std::size_t first_leaf) {
    if (reference == none) return none;
    if (is_leaf(reference))
        return leaf_reference(static_cast<std::uint32_t>(first_leaf) + leaf_index(reference));
    return reference + static_cast<std::int32_t>(first_node);
}

/// Bounding sphere of a run: about the middle of its box, rounded outward.
void bound_run(const std::vector<OrderFace>& leaf, std::size_t first, std::size_t end, FaceRun& run) {
    Box box;
    bool infinite = false;
    for (std::size_t i = first; i < end; ++i)
        for (const OrderCorner& corner : leaf[i].corners) {
            infinite = infinite || corner.position.w == 0;
            if (corner.position.w != 0) box.add(Vec3d(corner.position));
        }
    const Vec3d centre = rounded_to_float(0.5 * (box.low + box.high));
    run.centre = Vec3f(centre);
    double radius = 0;
    for (std::size_t i = first; i < end; ++i)
        for (const OrderCorner& corner : leaf[i].corners)
            if (corner.position.w != 0)
                radius = std::max(radius, glm::distance(centre, Vec3d(corner.position)));
    run.radius =
        infinite ? -1.0F
                 : std::nextafter(static_cast<float>(radius * (1 + 1e-7)), std::numeric_limits<float>::max());
}

bool present_together(const OrderFace& a, const OrderFace& b) {
    return a.slot == b.slot && a.alternative == b.alternative && a.detail == b.detail && a.level == b.level;
}

/// Into VisualDatabase::detail_levels.
std::int32_t level_number(const Registry& registry, std::int32_t detail, std::uint32_t level) {
    if (detail == none) return none;
    const Detail& of = registry.authored_details[static_cast<std::size_t>(detail)].detail;
    return static_cast<std::int32_t>(of.first_level + level);
}

class ListAssembler {
public:
    ListAssembler(const Assembly& parts, VisualDatabase& database) : parts_(parts), database_(database) {}

    ListStatistics add(std::uint32_t list, const std::vector<std::uint32_t>& object_numbers) {
        const OrderedList& ordered = parts_.lists[list];
        const std::size_t first_node = database_.planes.size();
        const std::size_t first_leaf = database_.run_leaves.size();
        first_vertex_ = database_.vertices.size();
        statistics_ = {};
        statistics_.name = parts_.registry.lists[list].list.name;
        for (PlaneNode node : ordered.order.nodes) {
            node.front = moved(node.front, first_node, first_leaf);
            node.on = moved(node.on, first_node, first_leaf);
            node.back = moved(node.back, first_node, first_leaf);
            database_.planes.push_back(node);
        }
        for (const std::vector<OrderFace>& leaf : ordered.order.leaves)
            add_leaf(leaf, ordered, object_numbers);
        database_.lists[list].root = moved(ordered.order.root, first_node, first_leaf);
        statistics_.planes = static_cast<std::uint32_t>(ordered.order.nodes.size());
        statistics_.splits = ordered.order.splits;
        statistics_.vertices = static_cast<std::uint32_t>(database_.vertices.size() - first_vertex_);
        statistics_.faces_at_once = static_cast<std::uint32_t>(present_.most(database_));
        return statistics_;
    }

private:
    void add_leaf(const std::vector<OrderFace>& leaf, const OrderedList& ordered,
                  const std::vector<std::uint32_t>& object_numbers) {
        RunLeaf made{static_cast<std::uint32_t>(database_.runs.size()), 0};
        for (std::size_t first = 0; first < leaf.size();) {
            std::size_t end = first;
            while (end < leaf.size() && present_together(leaf[end], leaf[first]))
                ++end;
            FaceRun run;
            run.first_face = static_cast<std::uint32_t>(database_.faces.size());
            run.first_light = static_cast<std::uint32_t>(database_.lights.size());
            run.slot = leaf[first].slot;
            run.alternative = leaf[first].alternative;
            run.level = level_number(parts_.registry, leaf[first].detail, leaf[first].level);
            bound_run(leaf, first, end, run);
            for (std::size_t i = first; i < end; ++i) {
                const FaceSource& source = ordered.sources[leaf[i].source];
                if (source.is_light) {
                    add_light(source, run, object_numbers);
                } else {
                    add_face(leaf[i], source, object_numbers);
                    ++run.face_count;
                }
            }
            database_.runs.push_back(run);
            present_.add(run.slot, run.alternative, run.level, run.face_count);
            ++made.run_count;
            ++statistics_.runs;
            first = end;
        }
        database_.run_leaves.push_back(made);
    }

    void add_face(const OrderFace& ordered, const FaceSource& source,
                  const std::vector<std::uint32_t>& object_numbers) {
        const ModelFace& model = parts_.objects[source.object].faces[source.face];
        Face face;
        face.first_corner = static_cast<std::uint32_t>(database_.corners.size());
        face.corner_count = static_cast<std::uint16_t>(ordered.corners.size());
        face.colour = model.style.colour.value_or(0);
        face.object = object_numbers[source.object];
        face.normal = Vec3f(model.light_normal == Vec3d(0) ? model.plane.normal : model.light_normal);
        face.shading = model.style.shading;
        face.two_sided = model.style.two_sided ? 1 : 0;
        face.opacity = model.style.opacity;
        face.coloured = ordered.coloured ? 1 : 0;
        face.file = model.at.file;
        face.line = model.at.line;
        database_.faces.push_back(face);
        ++statistics_.faces;
        for (const OrderCorner& corner : ordered.corners)
            put_corner(corner);
    }

    void put_corner(const OrderCorner& corner) {
        database_.corners.push_back(vertex(corner));
        const auto code = [](double level) { return static_cast<std::uint8_t>(std::floor(level + 0.5)); };
        database_.corner_colours.push_back(
            {code(corner.colour.x), code(corner.colour.y), code(corner.colour.z), 0});
    }

    void add_light(const FaceSource& source, FaceRun& run, const std::vector<std::uint32_t>& object_numbers) {
        LightPoint light = parts_.objects[source.object].lights[source.face].point;
        light.place = run.face_count;
        light.object = object_numbers[source.object];
        database_.lights.push_back(light);
        ++run.light_count;
        ++statistics_.lights;
    }

    /// The vertex at the corner's point with its normal: a new one, or one that stands already.
    std::uint32_t vertex(const OrderCorner& corner) {
        const Vertex made{Vec4f(corner.position), Vec3f(corner.normal)};
        if (corner.point >= at_point_.size()) at_point_.resize(corner.point + 1, no_vertex);
        for (std::uint32_t v = at_point_[corner.point]; v != no_vertex; v = before_[v - first_vertex_])
            if (database_.vertices[v].normal == made.normal) return v;
        const auto index = static_cast<std::uint32_t>(database_.vertices.size());
        database_.vertices.push_back(made);
        before_.push_back(std::exchange(at_point_[corner.point], index));
        return index;
    }

    const Assembly& parts_;
    VisualDatabase& database_;
    ListStatistics statistics_;
    std::size_t first_vertex_ = 0;
    static constexpr std::uint32_t no_vertex = 0xffffffffU;
    std::vector<std::uint32_t> at_point_; ///< by point: the vertex made there last
    std::vector<std::uint32_t> before_;   ///< by vertex of the list: the one made at its point before
    MostAtOnce present_;                  ///< of its faces
};

void add_names(const Assembly& parts, VisualDatabase& database) {
    const Registry& registry = parts.registry;
    database.name = registry.name;
    for (const Source& source : parts.sources.files)
        database.source_files.push_back(source.name);
    database.colours = registry.colours;
    database.colour_names = registry.colour_names.names();
    database.suns = registry.suns.names();
    database.moving_objects = registry.moving_objects.names();
    for (std::size_t i = 0; i < registry.slots.size(); ++i)
        database.slots.push_back({registry.slots.names()[i], registry.alternatives[i]});
    for (const AuthoredList& list : registry.lists)
        database.lists.push_back(list.list);
    for (std::uint32_t i = 0; i < registry.authored_details.size(); ++i) {
        database.details.push_back(registry.authored_details[i].detail);
        for (const float to_m : registry.authored_details[i].to_m)
            database.detail_levels.push_back({i, to_m});
    }
}

/// Objects list by list; the number of each in the database. A list that holds none, a tile's or one that the machine fills, is given one
/// of its own name: the faces made in it belong to that.
std::vector<std::uint32_t> add_objects(const Assembly& parts, VisualDatabase& database) {
    std::vector<std::uint32_t> numbers(parts.objects.size(), 0);
    for (std::uint32_t list = 0; list < parts.lists.size(); ++list) {
        const std::size_t before = database.objects.size();
        for (std::size_t i = 0; i < parts.objects.size(); ++i) {
            const ModelObject& object = parts.objects[i];
            if (object.list != list) continue;
            numbers[i] = static_cast<std::uint32_t>(database.objects.size());
            database.objects.push_back({object.name, list, object.slot,
                                        static_cast<std::uint16_t>(object.alternative), 0,
                                        level_number(parts.registry, object.detail, object.level)});
        }
        if (database.objects.size() == before)
            database.objects.push_back({parts.registry.lists[list].list.name, list, none, 0, 0});
    }
    return numbers;
}

Box contents_box(const Assembly& parts, std::uint32_t cluster) {
    Box box;
    for (std::uint32_t i = 0; i < parts.lists.size(); ++i) {
        const ObjectList& list = parts.registry.lists[i].list;
        if (list.cluster != cluster || list.attachment == Attachment::eye) continue;
        for (const std::vector<OrderFace>& leaf : parts.lists[i].order.leaves)
            for (const OrderFace& face : leaf)
                for (const OrderCorner& corner : face.corners)
                    if (corner.position.w != 0) box.add(list.origin_m + Vec3d(corner.position));
    }
    return box;
}

void add_clusters(const Assembly& parts, VisualDatabase& database) {
    for (std::uint32_t i = 0; i < parts.registry.clusters.size(); ++i) {
        const AuthoredCluster& authored = parts.registry.clusters[i];
        const Box box = contents_box(parts, i);
        Cluster cluster;
        cluster.name = parts.registry.cluster_names.names()[i];
        cluster.group = parts.planes.cluster_groups[i];
        cluster.moving_object = authored.moving_object;
        cluster.reference_point_m = authored.reference_m.value_or(0.5 * (box.low + box.high));
        const Vec3d reach = box.any ? glm::max(glm::abs(box.low - cluster.reference_point_m),
                                               glm::abs(box.high - cluster.reference_point_m))
                                    : Vec3d(0.0);
        cluster.half_extent_m = Vec3f(authored.half_extent_m.value_or(reach));
        cluster.root = parts.planes.cluster_roots[i];
        database.clusters.push_back(cluster);
    }
}

} // namespace

VisualDatabase assemble(const Assembly& parts, CompileStatistics& statistics) {
    VisualDatabase database;
    add_names(parts, database);
    database.groups = parts.planes.groups;
    database.planes = parts.planes.nodes; // first, so that their references stand as they are
    statistics.priority_planes = static_cast<std::uint32_t>(database.planes.size());
    const std::vector<std::uint32_t> object_numbers = add_objects(parts, database);
    for (std::uint32_t list = 0; list < parts.lists.size(); ++list)
        statistics.lists.push_back(ListAssembler(parts, database).add(list, object_numbers));
    const auto coloured = [](const Face& face) { return face.coloured != 0; };
    if (std::none_of(database.faces.begin(), database.faces.end(), coloured)) database.corner_colours.clear();
    for (const Object& object : database.objects)
        ++statistics.lists[object.list].objects;
    add_clusters(parts, database);
    database.tiles = parts.tiles.tiles;
    database.tile_normals = parts.tiles.normals;
    for (std::size_t i = 0; i < database.tiles.size(); ++i)
        database.lists[database.tiles[i].list].tile = static_cast<std::int32_t>(i);
    return database;
}

} // namespace linkdig::database
