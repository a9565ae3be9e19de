#include "host/motion/helicopter.h"

#include "database/model/units.h"

#include <algorithm>

namespace linkdig::host {

namespace {

/// A first-order lag: `value` on its way to `command` with a time constant.
double lagged(double value, double command, double time_constant_s, double step_s) {
    return value + (command - value) * std::min(1.0, step_s / time_constant_s);
}

} // namespace

bool HelicopterState::operator==(const HelicopterState& other) const {
    return position_m == other.position_m && velocity_mps == other.velocity_mps &&
           attitude.heading_rad == other.attitude.heading_rad &&
           attitude.pitch_rad == other.attitude.pitch_rad && attitude.roll_rad == other.attitude.roll_rad;
}

HelicopterState flown(const HelicopterState& state, const HelicopterControls& controls, double step_s) {
    HelicopterState next = state;
    Attitude& attitude = next.attitude;
    attitude.pitch_rad =
        lagged(attitude.pitch_rad, -controls.stick_fore * greatest_tilt_rad, tilt_time_s, step_s);
    attitude.roll_rad =
        lagged(attitude.roll_rad, controls.stick_right * greatest_tilt_rad, tilt_time_s, step_s);
    attitude.heading_rad =
        modulo(attitude.heading_rad - controls.pedals_right * greatest_turn_rad_s * step_s, two_pi);

    const Vec3d ahead = direction(attitude.heading_rad, 0.0);
    const Vec3d starboard = direction(attitude.heading_rad - pi / 2.0, 0.0);
    const Vec3d level(state.velocity_mps.x, state.velocity_mps.y, 0.0);
    const Vec3d pull =
        (ahead * -tangent(attitude.pitch_rad) + starboard * tangent(attitude.roll_rad)) * gravity_mps2;
    next.velocity_mps = level + (pull - level * drag_per_s) * step_s;
    next.velocity_mps.z =
        lagged(state.velocity_mps.z, controls.collective * greatest_climb_mps, climb_time_s, step_s);
    next.position_m = state.position_m + next.velocity_mps * step_s;
    if (next.position_m.z < least_height_m) {
        next.position_m.z = least_height_m;
        next.velocity_mps.z = 0.0;
    }
    return next;
}

} // namespace linkdig::host
