#include "database/mesh/mesh_of_database.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

namespace linkdig::database {

namespace {

class Converter {
public:
    explicit Converter(const VisualDatabase& database) : database_(database) {}

    DatabaseMesh run() {
        result_.tiles = database_.tiles.size();
        std::vector<std::vector<std::uint32_t>> faces(database_.objects.size());
        for (std::uint32_t i = 0; i < database_.faces.size(); ++i)
            faces[database_.faces[i].object].push_back(i);
        for (std::uint32_t cluster = 0; cluster < database_.clusters.size(); ++cluster) {
            const std::int32_t cluster_node = add_node(database_.clusters[cluster].name, none);
            for (std::uint32_t list = 0; list < database_.lists.size(); ++list)
                if (database_.lists[list].cluster == cluster) add_list(list, cluster_node, faces);
        }
        return std::move(result_);
    }

private:
    std::int32_t add_node(const std::string& name, std::int32_t parent) {
        MeshNode node;
        node.name = name;
        node.parent = parent;
        result_.mesh.nodes.push_back(std::move(node));
        return static_cast<std::int32_t>(result_.mesh.nodes.size()) - 1;
    }

    void add_list(std::uint32_t list, std::int32_t parent,
                  const std::vector<std::vector<std::uint32_t>>& faces) {
        const std::int32_t list_node = add_node(database_.lists[list].name, parent);
        for (std::uint32_t object = 0; object < database_.objects.size(); ++object) {
            if (database_.objects[object].list != list || faces[object].empty()) continue;
            MeshNode& node =
                result_.mesh
                    .nodes[static_cast<std::size_t>(add_node(database_.objects[object].name, list_node))];
            points_.clear();
            for (const std::uint32_t face : faces[object])
                add_face(database_.faces[face], database_.lists[list].origin_m, node);
            if (node.faces.empty()) result_.mesh.nodes.pop_back();
        }
    }

    void add_face(const Face& face, const Vec3d& origin_m, MeshNode& node) {
        const auto* corners = database_.corners.data() + face.first_corner;
        const auto infinite = [&](std::uint32_t v) { return database_.vertices[v].position.w == 0; };
        if (std::any_of(corners, corners + face.corner_count, infinite)) {
            ++result_.at_infinity;
            return;
        }
        MeshFace made;
        made.material = material(face);
        for (std::uint32_t i = 0; i < face.corner_count; ++i) {
            const Vertex& vertex = database_.vertices[corners[i]];
            const Vec3f normal = face.shading == Shading::vertex ? vertex.normal : face.normal;
            made.corners.push_back(
                point(origin_m + Vec3d(Vec3f(vertex.position)), Vec3d(normal), corners[i], node));
        }
        node.faces.push_back(std::move(made));
        ++result_.faces;
    }

    std::uint32_t point(const Vec3d& position_m, const Vec3d& normal, std::uint32_t vertex, MeshNode& node) {
        const auto key = std::make_tuple(vertex, normal.x, normal.y, normal.z);
        const auto [found, is_new] = points_.emplace(key, static_cast<std::uint32_t>(node.points.size()));
        if (is_new) {
            node.points.emplace_back(position_m.y, position_m.z, position_m.x);
            node.normals.emplace_back(normal.y, normal.z, normal.x);
        }
        return found->second;
    }

    std::uint32_t material(const Face& face) {
        const auto key = std::make_tuple(face.colour, face.opacity, face.two_sided);
        const auto [found, is_new] =
            materials_.emplace(key, static_cast<std::uint32_t>(result_.mesh.materials.size()));
        if (is_new)
            result_.mesh.materials.push_back({database_.colour_names[face.colour],
                                              database_.colours[face.colour], face.two_sided != 0,
                                              face.opacity / 256.0});
        return found->second;
    }

    const VisualDatabase& database_;
    DatabaseMesh result_;
    std::map<std::tuple<std::uint32_t, double, double, double>, std::uint32_t> points_; ///< of one node
    std::map<std::tuple<std::uint16_t, std::uint16_t, std::uint8_t>, std::uint32_t> materials_;
};

} // namespace

DatabaseMesh mesh_of(const VisualDatabase& database) { return Converter(database).run(); }

} // namespace linkdig::database
