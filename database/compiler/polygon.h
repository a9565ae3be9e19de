#pragma once
/// Convex planar polygons over homogeneous corners: what is wrong with one, its plane, and which side a point
/// is on.

#include "database/model/vectors.h"

#include <glm/vec4.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace linkdig::database {

/// w = 1: a point; w = 0: a unit direction, the corner lies at infinity.
using Vec4d = glm::dvec4;

/// The front is dot(normal, p) > distance.
struct Plane {
    Vec3d normal{0, 0, 1};
    double distance = 0;
};

/// How far in front of the plane: metres of a point, sine of the angle of a direction.
inline double side_of(const Plane& plane, const Vec4d& corner) {
    return glm::dot(plane.normal, Vec3d(corner)) - plane.distance * corner.w;
}

/// The nearest value that a float holds. Through memory: g++ 12.2 from -O2 on drops the two conversions where its
/// vectoriser (-ftree-slp-vectorize) takes neighbouring components in pairs, and bytes would differ from clang++'s.
inline double rounded_to_float(double value) {
    volatile float rounded = static_cast<float>(value);
    return static_cast<double>(rounded);
}
inline Vec3d rounded_to_float(const Vec3d& v) {
    return {rounded_to_float(v.x), rounded_to_float(v.y), rounded_to_float(v.z)};
}

/// A point as it is stored: so that every check sees what the machine will draw.
inline Vec4d as_float(const Vec3d& position_m) { return {rounded_to_float(position_m), 1.0}; }

enum class PolygonFault { none, zero_area, not_planar, self_intersecting, concave };

struct PolygonReport {
    PolygonFault fault = PolygonFault::none;
    std::size_t corner = 0;   ///< where it shows
    double deviation_m = 0;   ///< largest distance of a corner from the plane
    double allowed_m = 0;     ///< of the deviation
    bool at_infinity = false; ///< every corner is a direction; the normal points at the eye
    Plane plane;
};

/// Least distance that counts when sides are told apart, and the least deviation that is still planar.
inline constexpr double plane_tolerance_m = 1e-3;
/// Planar up to this part of the extent, for large faces.
inline constexpr double planar_part = 1e-4;
/// The same for directions.
inline constexpr double direction_tolerance = 1e-6;

/// Three corners or more, finite. Corners run counter-clockwise seen from the front.
PolygonReport examine(std::span<const Vec4d> corners);

/// Do two polygons that lie in (about) one plane share more than a strip of `plane_tolerance_m`? Both convex.
bool overlap_in_plane(std::span<const Vec4d> a, std::span<const Vec4d> b, const Vec3d& normal);

/// The corners with directions replaced by points so far out that the polygon's shape shows.
std::vector<Vec3d> far_substitutes(std::span<const Vec4d> corners);

} // namespace linkdig::database
