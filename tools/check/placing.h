#pragma once
/// What there is to look at in a database, and moving objects placed so that nothing stands in anything else.

#include "database/model/visual_database.h"
#include "host/packet/frame_packet.h"
#include "tools/check/random_stream.h"

#include <string>
#include <vector>

namespace linkdig::tools {

/// A moving object or a static cluster, with the box about its finite faces in its own frame.
struct Thing {
    std::string name;
    std::int32_t moving_object = none; ///< or a static cluster
    Vec3d low_m{0};
    Vec3d high_m{0};
    Vec3d centre_m() const { return 0.5 * (low_m + high_m); }
    double radius_m() const { return 0.5 * glm::length(high_m - low_m); }
};

/// Everything that has finite faces, static things first.
std::vector<Thing> things_of(const VisualDatabase& database);

/// Rows of the packet's table of moving objects.
std::vector<MovingObject> place_moving_objects(const VisualDatabase& database,
                                               const std::vector<Thing>& things, RandomStream& random);

/// A point of a thing's frame in the world.
Vec3d in_world(const Thing& thing, const std::vector<MovingObject>& placed, const Vec3d& point_m);

} // namespace linkdig::tools
