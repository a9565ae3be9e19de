#pragma once
/// glTF (.gltf, .glb) and Wavefront OBJ (.obj) in, through Assimp.

#include "database/mesh/mesh.h"

#include <optional>
#include <string>

namespace linkdig::database {

/// Largest mesh file, bytes; the buffers that a .gltf names are not counted.
inline constexpr std::uint64_t max_mesh_bytes = std::uint64_t{256} << 20U;

struct MeshResult {
    std::optional<Mesh> mesh; ///< only nodes that have faces, in the file's order; or nothing
    std::string error;        ///< why: "there is no such file", or Assimp's words
};

/// Points and lines in the file are passed over; faces that name a point that is not there, and points that are
/// not finite, are errors. The same file gives the same mesh.
MeshResult read_mesh(const std::string& path);

} // namespace linkdig::database
