#include "database/compiler/ear_cutting.h"
#include "database/compiler/read_meshes.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <utility>

namespace linkdig::database {

namespace {

using Corners = std::vector<std::uint32_t>;

class NodeReader {
public:
    NodeReader(const MeshNode& node, const MeshPlacement& placement, Place at, ModelObject& object,
               MeshStatistics& statistics)
        : node_(node), placement_(placement), at_(at), object_(object), statistics_(statistics) {}

    void add(const MeshFace& from, const FaceStyle& style) {
        ++statistics_.polygons;
        Corners corners;
        for (const std::uint32_t corner : from.corners)
            corners.push_back(vertex(corner, style.shading == Shading::vertex));
        drop_coincident(corners);
        if (corners.size() < 3) {
            ++statistics_.without_area;
            return;
        }
        const PolygonFault fault = fault_of(corners);
        if (fault == PolygonFault::none || corners.size() == 3) {
            add_face(std::move(corners), fault, style);
            return;
        }
        ++statistics_.cut;
        std::vector<Vec3d> points;
        for (const std::uint32_t corner : corners)
            points.emplace_back(object_.vertices[corner].position);
        for (const auto& [a, b, c] : cut_ears(points)) {
            Corners triangle{corners[a], corners[b], corners[c]};
            const PolygonFault its = fault_of(triangle);
            add_face(std::move(triangle), its, style);
        }
    }

private:
    /// One vertex per place; where the file's normals count, one per place and normal.
    std::uint32_t vertex(std::uint32_t point, bool with_normal) {
        const Vec4d position = as_float(placement_.turn * (node_.points[point] * placement_.metres_per_unit) +
                                        placement_.position_m);
        Vec3d normal(0.0);
        if (with_normal && !node_.normals.empty()) normal = placement_.turn * node_.normals[point];
        const double length = glm::length(normal);
        if (length > 0) normal = normal / length;
        const auto key = std::make_tuple(position.x, position.y, position.z, normal.x, normal.y, normal.z);
        const auto [found, is_new] =
            vertices_.emplace(key, static_cast<std::uint32_t>(object_.vertices.size()));
        if (!is_new) return found->second;
        ModelVertex made{position, {}, {}, at_};
        if (length > 0) made.normal = normal;
        object_.vertices.push_back(std::move(made));
        return found->second;
    }

    void drop_coincident(Corners& corners) const {
        const auto same = [&](std::uint32_t a, std::uint32_t b) {
            return object_.vertices[a].position == object_.vertices[b].position;
        };
        corners.erase(std::unique(corners.begin(), corners.end(), same), corners.end());
        while (corners.size() > 1 && same(corners.front(), corners.back()))
            corners.pop_back();
    }

    PolygonFault fault_of(const Corners& corners) const {
        std::vector<Vec4d> positions;
        positions.reserve(corners.size());
        for (const std::uint32_t corner : corners)
            positions.push_back(object_.vertices[corner].position);
        return examine(positions).fault;
    }

    void add_face(Corners corners, PolygonFault fault, const FaceStyle& style) {
        if (fault != PolygonFault::none) {
            ++statistics_.without_area;
            return;
        }
        Corners turned = corners; // one and the same polygon may begin at any of its corners
        std::rotate(turned.begin(), std::min_element(turned.begin(), turned.end()), turned.end());
        if (!seen_.insert(std::move(turned)).second) {
            ++statistics_.doubled;
            return;
        }
        ModelFace face;
        face.corners = std::move(corners);
        face.style = style;
        face.at = at_;
        object_.faces.push_back(std::move(face));
        ++statistics_.faces;
    }

    const MeshNode& node_;
    const MeshPlacement& placement_;
    Place at_;
    ModelObject& object_;
    MeshStatistics& statistics_;
    std::map<std::tuple<double, double, double, double, double, double>, std::uint32_t> vertices_;
    std::set<Corners> seen_;
};

} // namespace

void add_node(const MeshNode& node, const MeshPlacement& placement, Place at,
              const std::vector<FaceStyle>& styles, ModelObject& object, MeshStatistics& statistics) {
    NodeReader reader(node, placement, at, object, statistics);
    for (const MeshFace& face : node.faces)
        reader.add(face, styles[face.material]);
}

} // namespace linkdig::database
