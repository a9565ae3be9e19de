#pragma once
/// Attitudes of views: along a line of sight, and mounted on one another.

#include "database/model/rotation.h"

namespace linkdig::host {

/// Attitude of an eye that looks along `sight` (any length but 0), its horizon level.
Attitude looking_along(const Vec3d& sight);

/// Attitude of a body whose axes stand as the columns of `world_from_body_axes` (a rotation). Straight up or
/// down the roll is 0.
Attitude attitude_of(const Mat3d& world_from_body_axes);

/// Attitude in the world of what is mounted with `mount` on a body that has `carrier`.
Attitude mounted(const Attitude& carrier, const Attitude& mount);

} // namespace linkdig::host
