#include "database/format/summary.h"

#include "database/model/edge_count.h"
#include "database/model/most_at_once.h"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

namespace linkdig::database {

namespace {

void include_vertex(const Vertex& vertex, ListSummary& list) {
    if (vertex.position.w == 0.0F) {
        list.reaches_infinity = true;
        return;
    }
    const Vec3f place(vertex.position);
    if (!list.extent) list.extent = Extent{place, place};
    for (int axis = 0; axis < 3; ++axis) {
        list.extent->least[axis] = std::min(list.extent->least[axis], place[axis]);
        list.extent->greatest[axis] = std::max(list.extent->greatest[axis], place[axis]);
    }
}

void count_faces(const VisualDatabase& database, DatabaseSummary& summary) {
    for (const Face& face : database.faces) {
        ObjectSummary& object = summary.objects[face.object];
        ListSummary& list = summary.lists[database.objects[face.object].list];
        ++object.faces;
        ++list.faces;
        object.corners += face.corner_count;
        list.corners += face.corner_count;
        if (face.shading == Shading::vertex) ++list.smooth_faces;
        for (std::uint32_t i = 0; i < face.corner_count; ++i)
            include_vertex(database.vertices[database.corners[face.first_corner + i]], list);
    }
}

void count_lights(const VisualDatabase& database, DatabaseSummary& summary) {
    for (const LightPoint& light : database.lights) {
        ++summary.objects[light.object].lights;
        ListSummary& list = summary.lists[database.objects[light.object].list];
        ++list.lights;
        include_vertex({.position = Vec4f(light.position, 1.0F)}, list);
    }
}

void count_leaf(const VisualDatabase& database, const RunLeaf& leaf, ListSummary& list, MostAtOnce& present) {
    ++list.leaves;
    list.runs += leaf.run_count;
    for (std::uint32_t i = 0; i < leaf.run_count; ++i) {
        const FaceRun& run = database.runs[leaf.first_run + i];
        present.add(run.slot, run.alternative, run.level, run.face_count);
    }
}

void walk_tree(const VisualDatabase& database, std::int32_t root, ListSummary& list) {
    MostAtOnce present;
    std::vector<std::pair<std::int32_t, std::uint32_t>> steps{{root, 0}};
    while (!steps.empty()) {
        const auto [reference, depth] = steps.back();
        steps.pop_back();
        if (is_leaf(reference)) {
            count_leaf(database, database.run_leaves[leaf_index(reference)], list, present);
        } else if (reference != none) {
            ++list.planes;
            list.tree_depth = std::max(list.tree_depth, depth + 1);
            const PlaneNode& plane = database.planes[static_cast<std::size_t>(reference)];
            for (const std::int32_t child : {plane.front, plane.on, plane.back})
                steps.emplace_back(child, depth + 1);
        }
    }
    list.faces_at_most = present.most(database);
}

using Position = std::array<float, 4>;

Position position_of(const VisualDatabase& database, const Face& face, std::uint32_t corner) {
    const Vec4f& p = database.vertices[database.corners[face.first_corner + corner]].position;
    return {p.x, p.y, p.z, p.w};
}

/// Edges are told apart by list and place: vertices with several normals stand at one place.
void count_levels(const VisualDatabase& database, DatabaseSummary& summary) {
    using Edge = std::pair<std::uint32_t, std::pair<Position, Position>>;
    std::vector<std::set<Edge>> edges(database.detail_levels.size());
    for (const Object& object : database.objects)
        if (object.level != none) ++summary.levels[static_cast<std::size_t>(object.level)].objects;
    for (const Face& face : database.faces) {
        const Object& object = database.objects[face.object];
        if (object.level == none) continue;
        const auto level = static_cast<std::size_t>(object.level);
        ++summary.levels[level].faces;
        for (std::uint32_t k = 0; k < face.corner_count; ++k) {
            const std::uint32_t next = k + 1 == face.corner_count ? 0 : k + 1;
            edges[level].insert({object.list, std::minmax(position_of(database, face, k),
                                                          position_of(database, face, next))});
        }
    }
    for (std::size_t level = 0; level < edges.size(); ++level)
        summary.levels[level].edges = edges[level].size();
}

} // namespace

DatabaseSummary summarise(const VisualDatabase& database) {
    DatabaseSummary summary;
    summary.lists.resize(database.lists.size());
    summary.objects.resize(database.objects.size());
    for (std::uint32_t i = 0; i < database.objects.size(); ++i)
        summary.lists[database.objects[i].list].objects.push_back(i);
    summary.levels.resize(database.detail_levels.size());
    count_faces(database, summary);
    count_levels(database, summary);
    count_lights(database, summary);
    for (std::size_t i = 0; i < database.lists.size(); ++i)
        walk_tree(database, database.lists[i].root, summary.lists[i]);
    const EdgeCounts edges = count_edges(database);
    for (std::size_t i = 0; i < database.objects.size(); ++i)
        summary.objects[i].edges = edges.objects[i];
    for (std::size_t i = 0; i < database.lists.size(); ++i) {
        summary.lists[i].edges = edges.lists[i];
        summary.lists[i].edges_at_most = edges.lists_at_most[i];
    }
    return summary;
}

} // namespace linkdig::database
