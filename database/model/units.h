#pragma once
/// Units that appear only in files that people write; inside, everything is SI and radians.

namespace linkdig {

inline constexpr double metres_per_foot = 0.3048;
inline constexpr double metres_per_nautical_mile = 1852.0;
inline constexpr double mps_per_knot = metres_per_nautical_mile / 3600.0;
inline constexpr double gravity_mps2 = 9.80665;

} // namespace linkdig
