#pragma once
/// Pass 3, too: [[mesh]] tables. A glTF or OBJ file's nodes become objects of a list.

#include "database/compiler/model_object.h"
#include "database/mesh/mesh.h"

#include <vector>

namespace linkdig::database {

/// Appends an object for each node; the file and what became of it to `files`.
void read_mesh_objects(AuthoredTable table, const Reading& reading, std::vector<ModelObject>& objects,
                       MeshFiles& files);

/// From the file's coordinates to those of the list.
struct MeshPlacement {
    double metres_per_unit = 1.0;
    Mat3d turn{1.0}; ///< list_from_file, without the unit
    Vec3d position_m{0.0};
};

/// Appends the node's polygons to the object. Polygons that are not planar or not convex are cut into triangles; what has
/// no area, or stands there already, is left out. `styles`: one per material.
void add_node(const MeshNode& node, const MeshPlacement& placement, Place at,
              const std::vector<FaceStyle>& styles, ModelObject& object, MeshStatistics& statistics);

} // namespace linkdig::database
