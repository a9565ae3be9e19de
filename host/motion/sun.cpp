#include "host/motion/sun.h"

#include "database/model/mathematics.h"
#include "database/model/rotation.h"

#include <cmath>

namespace linkdig::host {

Vec3f sun_vector(const SunPosition& position) {
    return {direction(position.azimuth_rad, position.elevation_rad)};
}

double reflected(double x, double least, double greatest) {
    const double width = greatest - least;
    if (!(width > 0.0)) return least;
    const double there_and_back = modulo(x - least, 2.0 * width);
    return least + (there_and_back <= width ? there_and_back : 2.0 * width - there_and_back);
}

SunPosition OceanSun::position(std::uint64_t frame, double rate_factor, double more_elevation_rad,
                               double phase_rad) const {
    const double frames = static_cast<double>(frame);
    // Whole turns are taken off before the conversion to radians: the error is that of one product, however
    // long it ran.
    const double turns = frames * (azimuth_increment_rad * rate_factor / two_pi);
    const double azimuth = initial.azimuth_rad + (turns - std::floor(turns)) * two_pi;
    const double elevation =
        initial.elevation_rad + frames * (elevation_increment_rad + more_elevation_rad) + phase_rad;
    return {modulo(azimuth, two_pi), reflected(elevation, least_elevation_rad, greatest_elevation_rad)};
}

} // namespace linkdig::host
