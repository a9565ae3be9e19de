#include "host/motion/daylight.h"

#include "database/model/mathematics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace linkdig::host {

namespace {

struct Row {
    double elevation_deg;
    double direct;
    double lamps;
    double authored_sky;
    Vec3d tint;
    Vec3d horizon, middle, zenith;
};

/// Low sun, sunset, the ends of civil, nautical and astronomical twilight. Night is brighter than it is, so that shapes
/// stay visible on a display. All EST.
const std::array<Row, 6>& table() {
    static const std::array<Row, 6> rows{{
        {-18.0, 0.25, 1.0, 0.0, {0.075, 0.088, 0.125}, {15, 18, 30}, {8, 10, 20}, {4, 5, 13}},
        {-12.0, 0.25, 1.0, 0.0, {0.110, 0.125, 0.175}, {38, 36, 56}, {16, 18, 38}, {7, 9, 24}},
        {-6.0, 0.25, 1.0, 0.0, {0.235, 0.240, 0.310}, {146, 84, 66}, {58, 55, 92}, {18, 25, 56}},
        {0.0, 0.45, 0.8, 0.0, {0.530, 0.460, 0.450}, {238, 152, 88}, {148, 126, 148}, {50, 70, 120}},
        {4.0, 0.85, 0.4, 0.3, {0.820, 0.720, 0.600}, {240, 200, 146}, {172, 176, 186}, {80, 116, 170}},
        {full_day_deg, 1.0, 0.0, 1.0, {1.0, 1.0, 1.0}, {240, 220, 190}, {180, 190, 200}, {90, 130, 185}},
    }};
    return rows;
}

Daylight of_row(const Row& row) {
    Daylight light;
    light.tint = row.tint;
    light.direct = row.direct;
    light.lamps = row.lamps;
    light.authored_sky = row.authored_sky;
    light.horizon = row.horizon;
    light.middle = row.middle;
    light.zenith = row.zenith;
    return light;
}

Daylight between(const Row& low, const Row& high, double part) {
    const auto mix = [part](const auto& a, const auto& b) { return a + (b - a) * part; };
    Daylight light;
    light.tint = mix(low.tint, high.tint);
    light.direct = mix(low.direct, high.direct);
    light.lamps = mix(low.lamps, high.lamps);
    light.authored_sky = mix(low.authored_sky, high.authored_sky);
    light.horizon = mix(low.horizon, high.horizon);
    light.middle = mix(low.middle, high.middle);
    light.zenith = mix(low.zenith, high.zenith);
    return light;
}

/// Where the sky's middle colour stands between horizon and zenith.
constexpr double middle_height = 0.55;

std::uint8_t whole_level(double value) {
    return static_cast<std::uint8_t>(std::floor(std::clamp(value, 0.0, 255.0) + 0.5));
}
Colour colour_of(const Vec3d& levels) {
    return {whole_level(levels.x), whole_level(levels.y), whole_level(levels.z)};
}
Vec3d levels_of(Colour code) {
    return {static_cast<double>(code.red), static_cast<double>(code.green), static_cast<double>(code.blue)};
}

} // namespace

double sun_elevation_deg(double hour) { return 60.0 * sine(two_pi * (hour - 6.0) / 24.0); }

Daylight daylight(double hour) {
    const double elevation = sun_elevation_deg(hour);
    const std::array<Row, 6>& rows = table();
    Daylight light;
    if (elevation < rows.front().elevation_deg) {
        light = of_row(rows.front());
    } else if (elevation < full_day_deg) {
        std::size_t above = 1;
        while (rows[above].elevation_deg <= elevation)
            ++above;
        const Row& low = rows[above - 1];
        const Row& high = rows[above];
        light =
            between(low, high, (elevation - low.elevation_deg) / (high.elevation_deg - low.elevation_deg));
    }
    light.full_day = elevation >= full_day_deg;
    light.sun_elevation_deg = elevation;
    return light;
}

Colour tinted(const Daylight& light, Colour code) { return colour_of(levels_of(code) * light.tint); }

Vec3d sky_levels(const Daylight& light, const Vec3d& authored, double height) {
    const Vec3d replaced = height < middle_height
                               ? light.horizon + (light.middle - light.horizon) * (height / middle_height)
                               : light.middle + (light.zenith - light.middle) *
                                                    ((height - middle_height) / (1.0 - middle_height));
    return authored * light.authored_sky + replaced * (1.0 - light.authored_sky);
}

Colour sky_colour(const Daylight& light, Colour authored, double height) {
    return colour_of(sky_levels(light, levels_of(authored), height));
}

ListLight under(const Daylight& light, float ambient, float diffuse) {
    const double lost = static_cast<double>(diffuse) * (1.0 - light.direct);
    return {static_cast<float>(std::min(1.0, static_cast<double>(ambient) + 0.5 * lost)),
            static_cast<float>(static_cast<double>(diffuse) * light.direct)};
}

} // namespace linkdig::host
