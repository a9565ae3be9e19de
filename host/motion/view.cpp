#include "host/motion/view.h"

#include <cmath>

namespace linkdig::host {

Attitude looking_along(const Vec3d& sight) {
    const double level = std::sqrt(sight.x * sight.x + sight.y * sight.y);
    return {.heading_rad = arc_tangent(sight.y, sight.x), .pitch_rad = arc_tangent(sight.z, level)};
}

Attitude attitude_of(const Mat3d& world_from_body_axes) {
    const Vec3d& forward = world_from_body_axes[0];
    const Vec3d& port = world_from_body_axes[1];
    const Vec3d& up = world_from_body_axes[2];
    Attitude attitude = looking_along(forward);
    // Below a millionth the heading of the line of sight is rounding noise: the port side has it.
    if (forward.x * forward.x + forward.y * forward.y < 1e-12)
        attitude.heading_rad = arc_tangent(-port.x, port.y);
    else
        attitude.roll_rad = arc_tangent(port.z, up.z);
    return attitude;
}

Attitude mounted(const Attitude& carrier, const Attitude& mount) {
    return attitude_of(world_from_body(carrier) * world_from_body(mount));
}

} // namespace linkdig::host
