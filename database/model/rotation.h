#pragma once
/// Attitudes. Body frame: x forward, y to port, z up. World: x east, y north, z up.

#include "database/model/mathematics.h"
#include "database/model/vectors.h"

namespace linkdig {

/// Attitude of a body. Heading is mathematical: counter-clockwise from east (aviation headings are converted
/// where people write them). Pitch positive bow up, roll positive starboard down.
struct Attitude {
    double heading_rad = 0.0;
    double pitch_rad = 0.0;
    double roll_rad = 0.0;
};

/// Rotation that takes body coordinates to world coordinates: Rz(heading) * Ry(-pitch) * Rx(roll).
inline Mat3d world_from_body(const Attitude& attitude) {
    const SineCosine h = sine_cosine(attitude.heading_rad);
    const SineCosine p = sine_cosine(attitude.pitch_rad);
    const SineCosine r = sine_cosine(attitude.roll_rad);
    const Vec3d forward(p.cosine * h.cosine, p.cosine * h.sine, p.sine);
    const Vec3d level_port(-h.sine, h.cosine, 0.0);
    const Vec3d level_up(-p.sine * h.cosine, -p.sine * h.sine, p.cosine);
    const Vec3d port = r.cosine * level_port + r.sine * level_up;
    const Vec3d up = r.cosine * level_up - r.sine * level_port;
    return {forward, port, up}; // GLM matrices are built of columns
}

/// Unit vector towards azimuth (counter-clockwise from east) and elevation above the horizon.
inline Vec3d direction(double azimuth_rad, double elevation_rad) {
    const SineCosine a = sine_cosine(azimuth_rad);
    const SineCosine e = sine_cosine(elevation_rad);
    return {e.cosine * a.cosine, e.cosine * a.sine, e.sine};
}

/// Aviation heading (clockwise from north, radians) to mathematical heading (counter-clockwise from east),
/// and back.
constexpr double heading_from_aviation(double aviation_rad) { return pi / 2.0 - aviation_rad; }
constexpr double aviation_from_heading(double heading_rad) { return pi / 2.0 - heading_rad; }

} // namespace linkdig
