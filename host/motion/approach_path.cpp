#include "host/motion/approach_path.h"

#include <algorithm>

namespace linkdig::host {

namespace {

Vec3d bezier(const std::array<Vec3d, 4>& control, double u) {
    const double v = 1.0 - u;
    return control[0] * (v * v * v) + control[1] * (3.0 * v * v * u) + control[2] * (3.0 * v * u * u) +
           control[3] * (u * u * u);
}

} // namespace

double easing(double fraction) {
    const double t = std::clamp(fraction, 0.0, 1.0);
    const double cubed = t * t * t;
    return (5.0 / 3.0) * t * (1.0 - cubed) + cubed * t * t;
}

EyeAndAim ApproachPath::at(double time_s) const {
    const double u = easing(time_s / duration_s);
    return {bezier(control_m, u), first_aim_m + (last_aim_m - first_aim_m) * u};
}

} // namespace linkdig::host
