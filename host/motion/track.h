#pragma once
/// Where a ship's mean frame is: her track, as a pure function of time.

#include "database/model/vectors.h"

#include <cstdint>

namespace linkdig::host {

/// Origin and heading of the mean frame (x forward, y to port, z up, on the track, on the water).
struct Steering {
    Vec3d position_m{0};
    double heading_rad = 0.0;
    Mat3d world_from_mean() const;
};

struct ShipTrack {
    enum class Kind : std::uint8_t {
        straight,
        turn,            ///< a circle from begin_s on, through angle_rad, then straight again
        figure_of_eight, ///< from begin_s on a circle to one side and one to the other, and so on
    };
    Vec3d start_m{0}; ///< of the waterline frame's origin at time 0, world
    double heading_rad = 0.0;
    double speed_mps = 0.0;
    Kind kind = Kind::straight;
    double begin_s = 0.0;
    double radius_m = 1.0; ///< > 0
    bool to_port = false;
    double angle_rad = 0.0; ///< 0: for ever
    Vec3d station_m{0};     ///< the ship keeps this place in the track's own frame (a leader's)

    /// Continuous in place and heading for all times.
    Steering at(double time_s) const;
    /// Along the heading: on a station in a turn another than the leader's. Metres a second.
    double speed_at(double time_s) const;

private:
    Steering along(double time_s) const;
};

} // namespace linkdig::host
