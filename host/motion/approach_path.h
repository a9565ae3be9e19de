#pragma once
/// The own ship's approach: a curve beside a ship that ends in a hover, flown slower and slower as a pilot
/// does.

#include "database/model/vectors.h"

#include <array>

namespace linkdig::host {

/// Where the pilot's eye is and what it looks at, both in the frame of the approach (a ship's mean frame).
struct EyeAndAim {
    Vec3d eye_m{0};
    Vec3d aim_m{0};
};

struct ApproachPath {
    std::array<Vec3d, 4> control_m; ///< of a cubic Bezier curve: start, two handles, hover
    Vec3d first_aim_m{0};           ///< what the pilot looks at when the approach begins
    Vec3d last_aim_m{0};            ///< and in the hover
    double duration_s = 1.0;        ///< > 0; afterwards the hover is held

    /// Twice continuously differentiable for time > 0, also where the hover begins. Times below 0 count as 0.
    EyeAndAim at(double time_s) const;
};

/// Way made good along the curve at a fraction of the time, both 0 to 1: 5/3 t - 5/3 t^4 + t^5. Its speed
/// falls monotonically from 5/3 of the mean to 0, and so does its deceleration to 0 at the end: nothing jerks
/// in the hover.
double easing(double fraction);

} // namespace linkdig::host
