#include "host/motion/ship.h"

namespace linkdig::host {

Mat3d ShipTrack::world_from_mean() const { return world_from_body({.heading_rad = heading_rad}); }

Vec3d ShipTrack::position_m(double time_s) const {
    return start_m + direction(heading_rad, 0.0) * (speed_mps * time_s);
}

MovingObject ship_at(const ShipTrack& track, const ShipMotion& motion, double time_s, double pitch_factor) {
    const ShipMotionValues values = motion.at(time_s);
    const auto value = [&](ShipAxis axis) { return values[static_cast<std::size_t>(axis)]; };
    MovingObject object;
    const Vec3d drift(value(ShipAxis::surge), value(ShipAxis::sway), 0.0);
    object.waterline_position_m = track.position_m(time_s) + track.world_from_mean() * drift;
    object.waterline_heading_rad = track.heading_rad + value(ShipAxis::yaw);
    object.position_m = object.waterline_position_m + Vec3d(0.0, 0.0, value(ShipAxis::heave));
    object.attitude = {.heading_rad = object.waterline_heading_rad,
                       .pitch_rad = value(ShipAxis::pitch) * pitch_factor,
                       .roll_rad = value(ShipAxis::roll)};
    return object;
}

} // namespace linkdig::host
