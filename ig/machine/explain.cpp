#include "ig/machine/explain.h"

#include "ig/edges/edges.h"
#include "ig/priority/plane_tree.h"

#include <algorithm>
#include <span>

namespace linkdig::ig {

namespace {

/// First element that the given edges say on a line; false if none of them spans it.
bool crossing(const Edge* edges, std::uint32_t count, std::int32_t line, std::int32_t& element) {
    for (const Edge* edge = edges; edge != edges + count; ++edge) {
        if (line < edge->first_line || line >= edge->end_line) continue;
        element = first_element(*edge, line);
        return true;
    }
    return false;
}

bool covers(const FaceEdges& edges, const EdgeFace& face, std::int32_t line, std::int32_t element) {
    const Edge* first = edges.edges.data() + face.first_edge;
    std::int32_t begin = 0;
    std::int32_t end = 0;
    return crossing(first, face.leading, line, begin) &&
           crossing(first + face.leading, face.trailing, line, end) && begin <= element && element < end;
}

/// Collects the planes from a tree's root to the leaf that `is_target` knows, root first.
class PathFinder {
public:
    PathFinder(std::span<const PlaneNode> planes, PlaneTaken::Tree tree, std::vector<PlaneTaken>& path)
        : planes_(planes), tree_(tree), path_(path) {}

    /// eye_for(node) gives the eye in the frame that the node hangs in.
    template <typename Eye, typename Target>
    bool find(std::int32_t reference, const Eye& eye_for, const Target& is_target) {
        if (reference == none) return false;
        if (is_leaf(reference)) return is_target(leaf_index(reference));
        const PlaneNode& node = planes_[static_cast<std::size_t>(reference)];
        const Vec3d eye = eye_for(node);
        const std::int32_t children[3] = {node.front, node.on, node.back};
        for (int side = 0; side < 3; ++side) {
            path_.push_back(
                {.tree = tree_,
                 .normal = node.normal,
                 .distance_m = node.distance,
                 .eye_distance_m = glm::dot(Vec3d(node.normal), eye) - static_cast<double>(node.distance),
                 .eye_in_front = in_front_of(node, eye),
                 .side = static_cast<PlaneTaken::Side>(side)});
            if (find(children[side], eye_for, is_target)) return true;
            path_.pop_back();
        }
        return false;
    }

private:
    std::span<const PlaneNode> planes_;
    PlaneTaken::Tree tree_;
    std::vector<PlaneTaken>& path_;
};

void find_planes(const StageOutputs& outputs, const FaceBlock& block, std::uint32_t face, Layer& layer) {
    const ActiveDatabase& active = *outputs.active;
    const VisualDatabase& database = *active.database;
    const Cluster& cluster = database.clusters[block.cluster];
    const ClusterPose& pose = active.poses[block.cluster];
    const Vec3d eye = outputs.eye_m;
    PathFinder(database.planes, PlaneTaken::Tree::group, layer.planes)
        .find(
            database.groups[cluster.group].root, [&](const PlaneNode&) { return eye; },
            [&](std::uint32_t leaf) { return leaf == block.cluster; });
    PathFinder(database.planes, PlaneTaken::Tree::cluster, layer.planes)
        .find(
            cluster.root,
            [&](const PlaneNode& node) {
                return node.waterline != 0
                           ? glm::transpose(pose.world_from_waterline) * (eye - pose.waterline_origin_m)
                           : glm::transpose(pose.world_from_body) * (eye - pose.body_origin_m);
            },
            [&](std::uint32_t leaf) { return leaf == block.list; });
    PathFinder(database.planes, PlaneTaken::Tree::list, layer.planes)
        .find(
            block.root,
            [&](const PlaneNode&) {
                return block.at_eye ? Vec3d(0)
                                    : glm::transpose(block.world_from_list) * (eye - block.origin_m);
            },
            [&](std::uint32_t leaf) {
                const RunLeaf& runs = block.leaves[leaf];
                for (std::uint32_t r = runs.first_run; r < runs.first_run + runs.run_count; ++r) {
                    const FaceRun& run = block.runs[r];
                    if (face >= run.first_face && face < run.first_face + run.face_count) return true;
                }
                return false;
            });
}

Layer layer_of(const StageOutputs& outputs, std::uint32_t rank, std::int32_t line, std::int32_t element) {
    const ProjectedFace& projected = outputs.projected->faces[rank];
    const FaceBlock& block = outputs.active->blocks[projected.block];
    const Face& face = block.faces[projected.face];
    const VisualDatabase& database = *outputs.active->database;
    Layer layer{.rank = rank, .list = block.list, .object = face.object, .cluster = block.cluster};
    layer.group_number = database.groups[database.clusters[block.cluster].group].number;
    layer.list_number = block.number;
    layer.colour = projected.colour;
    layer.file = face.file;
    layer.line = face.line;
    layer.shading = face.shading == Shading::vertex && !block.smooth ? Shading::face : face.shading;
    layer.normal = face.normal;
    layer.sun = block.sun;
    layer.ambient = block.ambient;
    layer.diffuse = block.diffuse;
    layer.intensity = projected.intensity;
    layer.level = database.objects[face.object].level;
    layer.level_opacity = projected.fade;
    const FaceShading& shading = outputs.edges->shadings[rank];
    layer.coloured = shading.coloured;
    if (layer.coloured) {
        const TintPlanes& tint = tint_of(*outputs.edges, shading);
        for (std::size_t k = 0; k < tint.size(); ++k)
            layer.tint[k] = intensity_at(tint[k], line, element);
    } else if (projected.triangle >= 0) {
        layer.smooth = true;
        layer.intensity = intensity_at(shading.plane, line, element);
        const IntensityTriangle& triangle =
            outputs.projected->triangles[static_cast<std::size_t>(projected.triangle)];
        std::copy(triangle.intensity, triangle.intensity + 3, layer.corner_intensity);
    }
    find_planes(outputs, block, projected.face, layer);
    return layer;
}

} // namespace

std::vector<Layer> explain_pixel(const StageOutputs& outputs, const PixelMakeUp& made, std::uint32_t line,
                                 std::uint32_t element) {
    const auto l = static_cast<std::int32_t>(line), e = static_cast<std::int32_t>(element);
    std::vector<Layer> layers;
    for (std::uint32_t rank = 0; rank < outputs.projected->faces.size(); ++rank) {
        const bool centre = covers(*outputs.edges, outputs.edges->faces[rank], l, e);
        if (!centre && std::ranges::find(made.shares, rank, &PixelShare::rank) == made.shares.end()) continue;
        layers.push_back(layer_of(outputs, rank, l, e));
        layers.back().covers_centre = centre;
    }
    return layers;
}

} // namespace linkdig::ig
