#pragma once
/// The own ship flown by hand: simple helicopter kinematics. The stick commands an attitude, the pedals a rate of turn, the
/// collective a rate of climb; the thrust that the tilt turns sideways moves her, and drag holds her back. Every constant is
/// estimated: no helicopter is meant.

#include "database/model/rotation.h"

namespace linkdig::host {

/// Each -1 to 1.
struct HelicopterControls {
    double stick_fore = 0.0;   ///< nose down, faster ahead
    double stick_right = 0.0;  ///< starboard down
    double pedals_right = 0.0; ///< nose to starboard
    double collective = 0.0;   ///< up
};

struct HelicopterState {
    Vec3d position_m{0};
    Vec3d velocity_mps{0};
    Attitude attitude;
    bool operator==(const HelicopterState& other) const;
};

inline constexpr double greatest_tilt_rad = radians(20.0);
inline constexpr double greatest_turn_rad_s = radians(30.0);
inline constexpr double greatest_climb_mps = 8.0;
inline constexpr double tilt_time_s = 0.6;  ///< in which an attitude follows the stick
inline constexpr double climb_time_s = 0.8; ///< in which the climb follows the collective
inline constexpr double drag_per_s = 0.07;  ///< full tilt makes about 50 m/s
inline constexpr double least_height_m = 2.0;

/// The state `step_s` later; step_s above 0 and at most 0.2. A pure function.
HelicopterState flown(const HelicopterState& state, const HelicopterControls& controls, double step_s);

} // namespace linkdig::host
