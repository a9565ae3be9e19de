#pragma once
/// Repeated tiles: squares with a pattern of normals, out to the horizon.

#include "database/compiler/model_object.h"

#include <vector>

namespace linkdig::database {

struct Tiles {
    std::vector<RepeatedTile> tiles;
    std::vector<Vec3f> normals;
};

/// Reads the [[tile]] tables. A tile's list must be static and hold nothing else.
Tiles read_tiles(const AuthoredTables& tables, const std::vector<ModelObject>& objects,
                 const Reading& reading);

} // namespace linkdig::database
