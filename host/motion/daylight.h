#pragma once
/// What the hour does to light and colours: day, dusk and night as numbers for a frame packet.
///
/// Everything hangs on the sun's elevation e (degrees): e = 60 sin(2 pi (h - 6) / 24), a day that rises at 6 and sets at
/// 18 h. From `full_day_deg` on nothing is changed; below, values are interpolated between the rows of one table
/// (daylight.cpp). All of it is estimated (EST): chosen by looking, no photometry.

#include "database/model/vectors.h"
#include "database/model/visual_database.h"

namespace linkdig::host {

/// From this elevation on it is full day (EST).
inline constexpr double full_day_deg = 12.0;

struct Daylight {
    double sun_elevation_deg = 60.0;
    bool full_day = true;
    Vec3d tint{1.0};           ///< factor on the colours of faces
    double direct = 1;         ///< factor on the diffuse part of their light: what is left of a sun
    double lamps = 0.0;        ///< 0 by day, 1 in the dark: how far light points are turned up
    double authored_sky = 1.0; ///< how much of the sky's own colours is left
    Vec3d horizon{0}, middle{0}, zenith{0}; ///< of the sky that replaces them, levels 0 to 255
};

/// Elevation of the sun at an hour, any real number; degrees.
double sun_elevation_deg(double hour);

Daylight daylight(double hour);

/// A colour code of a face under this light, and of the sky at `height`: 0 at the horizon, 1 at the zenith.
Colour tinted(const Daylight& light, Colour code);
Colour sky_colour(const Daylight& light, Colour authored, double height);
/// The same for levels that are no whole numbers (the packet's sky).
Vec3d sky_levels(const Daylight& light, const Vec3d& authored, double height);

/// What a list's light becomes: half of the diffuse light that is lost comes back from everywhere (EST).
struct ListLight {
    float ambient = 0;
    float diffuse = 0;
};
ListLight under(const Daylight& light, float ambient, float diffuse);

} // namespace linkdig::host
