#pragma once
/// A mesh as files exchange it: nodes with polygons, materials by name. What read_mesh returns and write_mesh takes.

#include "database/model/vectors.h"
#include "database/model/visual_database.h"

#include <cstdint>
#include <string>
#include <vector>

namespace linkdig::database {

struct MeshMaterial {
    std::string name;
    Colour colour;
    bool two_sided = false;
    double opacity = 1.0; ///< 0 to 1
    bool operator==(const MeshMaterial&) const = default;
};

struct MeshFace {
    std::vector<std::uint32_t> corners; ///< into points, three or more, counter-clockwise seen from the front
    std::uint32_t material = 0;         ///< into Mesh::materials
    bool operator==(const MeshFace&) const = default;
};

/// Points are in the file's unit and axes, with the transforms of all nodes above it applied.
struct MeshNode {
    std::string name;
    std::int32_t parent = none; ///< into Mesh::nodes, an earlier one; of a mesh that was read always none
    std::vector<Vec3d> points;
    /// Parallel to points, or empty: the file gives none. Not always of unit length.
    std::vector<Vec3d> normals;
    std::vector<MeshFace> faces;
    bool operator==(const MeshNode&) const = default;
};

struct Mesh {
    std::vector<MeshMaterial> materials;
    std::vector<MeshNode> nodes;
    bool operator==(const Mesh&) const = default;
};

} // namespace linkdig::database
