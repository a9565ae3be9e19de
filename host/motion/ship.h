#pragma once
/// A ship under way: her track, her motion about it, and the frames that follow from both.

#include "host/motion/ship_motion.h"
#include "host/packet/frame_packet.h"

namespace linkdig::host {

/// Straight, at constant speed.
struct ShipTrack {
    Vec3d start_m{0}; ///< of the waterline frame's origin at time 0, world
    double heading_rad = 0.0;
    double speed_mps = 0.0;

    /// Origin of the mean frame (x forward, y to port, z up, on the track, on the water) at a time.
    Vec3d position_m(double time_s) const;
    Mat3d world_from_mean() const;
};

/// The packet's row for a ship: the waterline frame has surge, sway and yaw, the body frame also heave, pitch
/// and roll. `pitch_factor` multiplies the pitch.
MovingObject ship_at(const ShipTrack& track, const ShipMotion& motion, double time_s, double pitch_factor);

} // namespace linkdig::host
