#include "database/format/summary.h"

#include <algorithm>
#include <map>
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

using FacesOfAlternative = std::map<std::pair<std::int32_t, std::uint32_t>, std::uint64_t>;

void count_leaf(const VisualDatabase& database, const RunLeaf& leaf, ListSummary& list,
                FacesOfAlternative& alternatives) {
    ++list.leaves;
    list.runs += leaf.run_count;
    for (std::uint32_t i = 0; i < leaf.run_count; ++i) {
        const FaceRun& run = database.runs[leaf.first_run + i];
        alternatives[{run.slot, run.slot == none ? 0 : run.alternative}] += run.face_count;
    }
}

/// The map is ordered by slot: the most of each slot's alternatives, and all of what belongs to no slot.
std::uint64_t most_at_once(const FacesOfAlternative& alternatives) {
    std::uint64_t total = 0;
    std::uint64_t most = 0;
    std::int32_t slot = none;
    for (const auto& [key, faces] : alternatives) {
        if (key.first != slot) {
            total += most;
            most = 0;
            slot = key.first;
        }
        most = std::max(most, faces);
    }
    return total + most;
}

void walk_tree(const VisualDatabase& database, std::int32_t root, ListSummary& list) {
    FacesOfAlternative alternatives;
    std::vector<std::pair<std::int32_t, std::uint32_t>> steps{{root, 0}};
    while (!steps.empty()) {
        const auto [reference, depth] = steps.back();
        steps.pop_back();
        if (is_leaf(reference)) {
            count_leaf(database, database.run_leaves[leaf_index(reference)], list, alternatives);
        } else if (reference != none) {
            ++list.planes;
            list.tree_depth = std::max(list.tree_depth, depth + 1);
            const PlaneNode& plane = database.planes[static_cast<std::size_t>(reference)];
            for (const std::int32_t child : {plane.front, plane.on, plane.back})
                steps.emplace_back(child, depth + 1);
        }
    }
    list.faces_at_most = most_at_once(alternatives);
}

} // namespace

DatabaseSummary summarise(const VisualDatabase& database) {
    DatabaseSummary summary;
    summary.lists.resize(database.lists.size());
    summary.objects.resize(database.objects.size());
    for (std::uint32_t i = 0; i < database.objects.size(); ++i)
        summary.lists[database.objects[i].list].objects.push_back(i);
    count_faces(database, summary);
    for (std::size_t i = 0; i < database.lists.size(); ++i)
        walk_tree(database, database.lists[i].root, summary.lists[i]);
    return summary;
}

} // namespace linkdig::database
