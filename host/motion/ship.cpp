#include "host/motion/ship.h"

namespace linkdig::host {

ShipMotionValues ShipMover::at(double time_s, const Steering& steering) const {
    if (!history.values.empty()) return history.at(time_s);
    if (!curved.empty()) return curved.at(time_s, steering);
    return straight.at(time_s);
}

MovingObject ship_at(const Steering& steering, const ShipMotionValues& values, const MotionFactors& factors) {
    const auto value = [&](ShipAxis axis) { return values[static_cast<std::size_t>(axis)] * factors.all; };
    MovingObject object;
    const Vec3d drift(value(ShipAxis::surge), value(ShipAxis::sway), 0.0);
    object.waterline_position_m = steering.position_m + steering.world_from_mean() * drift;
    object.waterline_heading_rad = steering.heading_rad + value(ShipAxis::yaw);
    object.position_m = object.waterline_position_m + Vec3d(0.0, 0.0, value(ShipAxis::heave));
    object.attitude = {.heading_rad = object.waterline_heading_rad,
                       .pitch_rad = value(ShipAxis::pitch) * factors.pitch,
                       .roll_rad = value(ShipAxis::roll)};
    return object;
}

} // namespace linkdig::host
