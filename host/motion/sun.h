#pragma once
/// Suns. The ocean's turns (report, 3.1.4 and Figure 7); all others stand still.

#include "database/model/vectors.h"

#include <cstdint>

namespace linkdig::host {

/// Azimuth counter-clockwise from east (w in Figure 7) and elevation above the horizon (theta), radians.
struct SunPosition {
    double azimuth_rad = 0.0;
    double elevation_rad = 0.0;
};

/// Unit vector towards a sun, world.
Vec3f sun_vector(const SunPosition& position);

/// Figure 7's sun: each frame w advances by one increment and theta by the other. As drawn theta would grow
/// without bound: here it is reflected between two limits, and its increment is 0 unless the scenario says
/// otherwise. The position is computed from the frame number, never accumulated, so that it does not drift in
/// hours of running.
struct OceanSun {
    SunPosition initial;
    double azimuth_increment_rad = 0.0;   ///< per frame
    double elevation_increment_rad = 0.0; ///< per frame
    double least_elevation_rad = 0.0;     ///< least <= initial elevation <= greatest
    double greatest_elevation_rad = 1.5707963267948966;

    /// Position in a frame; azimuth in [0, 2 pi). `rate_factor` multiplies the azimuth increment for all
    /// frames from 0.
    SunPosition position(std::uint64_t frame, double rate_factor = 1.0) const {
        return position(frame, rate_factor, 0.0, 0.0);
    }
    /// The same with another elevation increment on top of its own, and with `phase_rad` added before the elevation is
    /// reflected.
    SunPosition position(std::uint64_t frame, double rate_factor, double more_elevation_rad,
                         double phase_rad) const;
};

/// x reflected to and fro between two limits, as a ball between two walls; the lower limit if they are equal.
double reflected(double x, double least, double greatest);

} // namespace linkdig::host
