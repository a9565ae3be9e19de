#include "host/motion/track.h"

#include "database/model/rotation.h"

#include <algorithm>
#include <cmath>

namespace linkdig::host {

namespace {

/// From a point on a circle of radius r, `turned` radians further (positive to port).
Steering on_circle(const Steering& from, double radius_m, double turned) {
    const double side = turned < 0.0 ? -1.0 : 1.0;
    const Vec3d centre = from.position_m + direction(from.heading_rad + side * pi / 2.0, 0.0) * radius_m;
    const double heading = from.heading_rad + turned;
    return {centre + direction(heading - side * pi / 2.0, 0.0) * radius_m, heading};
}

} // namespace

Mat3d Steering::world_from_mean() const { return world_from_body({.heading_rad = heading_rad}); }

Steering ShipTrack::along(double time_s) const {
    const Vec3d ahead = direction(heading_rad, 0.0);
    if (kind == Kind::straight || time_s <= begin_s)
        return {start_m + ahead * (speed_mps * time_s), heading_rad};
    const Steering helm_over{start_m + ahead * (speed_mps * begin_s), heading_rad};
    const double side = to_port ? 1.0 : -1.0;
    const double turned = speed_mps * (time_s - begin_s) / radius_m; // radians, without its sign
    if (kind == Kind::figure_of_eight) {
        const double in_figure = modulo(turned, 2.0 * two_pi);
        return in_figure <= two_pi ? on_circle(helm_over, radius_m, side * in_figure)
                                   : on_circle(helm_over, radius_m, -side * (in_figure - two_pi));
    }
    if (angle_rad <= 0.0) return on_circle(helm_over, radius_m, side * modulo(turned, two_pi));
    Steering steadied = on_circle(helm_over, radius_m, side * std::min(turned, angle_rad));
    const double beyond_m = std::max(0.0, turned - angle_rad) * radius_m;
    steadied.position_m += direction(steadied.heading_rad, 0.0) * beyond_m;
    return steadied;
}

double ShipTrack::speed_at(double time_s) const {
    constexpr double step_s = 0.05; // a difference of places: exact on straight tracks
    const Vec3d moved = at(time_s + step_s).position_m - at(time_s - step_s).position_m;
    return glm::dot(moved, direction(at(time_s).heading_rad, 0.0)) / (2.0 * step_s);
}

Steering ShipTrack::at(double time_s) const {
    Steering steering = along(time_s);
    if (station_m != Vec3d(0.0)) steering.position_m += steering.world_from_mean() * station_m;
    return steering;
}

} // namespace linkdig::host
