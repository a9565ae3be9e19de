#pragma once
/// A ship under way: her track, her motion about it, and the frames that follow from both.

#include "host/motion/motion_history.h"
#include "host/motion/ship_motion.h"
#include "host/motion/track.h"
#include "host/packet/frame_packet.h"

namespace linkdig::host {

/// What moves a ship about her track; of the three the first that is there: a table, waves along a curved track, waves
/// along a straight one. None: she does not move about it.
struct ShipMover {
    MotionHistory history;
    CurvedMotion curved;
    ShipMotion straight;

    ShipMotionValues at(double time_s, const Steering& steering) const;
};

/// How strongly a ship moves, beside what moves her.
struct MotionFactors {
    double all = 1.0;
    double pitch = 1.0;
};

/// The packet's row for a ship: the waterline frame has surge, sway and yaw, the body frame also heave, pitch
/// and roll.
MovingObject ship_at(const Steering& steering, const ShipMotionValues& values, const MotionFactors& factors);

} // namespace linkdig::host
