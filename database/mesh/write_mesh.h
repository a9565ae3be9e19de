#pragma once
/// glTF 2.0 out, through Assimp.

#include "database/mesh/mesh.h"

#include <string>

namespace linkdig::database {

/// Writes `path`, which ends in .glb, or in .gltf: its buffer then stands beside it, with the ending .bin. Polygons are cut
/// into fans of triangles from their first corner. Throws std::runtime_error, naming the path and the reason.
void write_mesh(const Mesh& mesh, const std::string& path);

} // namespace linkdig::database
