#include "ig/geometry/depth_plane.h"

#include "database/model/vectors.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace linkdig::ig {

namespace {

Vec3d position(const ClipPoint& p) { return {p.x, p.y, p.z}; }

/// From a finite corner towards another one, or in the direction of one at infinity.
Vec3d towards(const ClipPoint& base, const ClipPoint& p) {
    return p.w == 0.0 ? position(p) : position(p) - position(base);
}

/// Twice the largest triangle that a corner forms with the first edge: a normal that no sliver spoils.
Vec3d normal_of(std::span<const ClipPoint> polygon, const ClipPoint& base) {
    Vec3d best(0);
    const ClipPoint* first = nullptr;
    for (const ClipPoint& p : polygon) {
        if (&p == &base) continue;
        if (first == nullptr) {
            first = &p;
            continue;
        }
        const Vec3d normal = glm::cross(towards(base, *first), towards(base, p));
        if (glm::dot(normal, normal) > glm::dot(best, best)) best = normal;
    }
    return best;
}

/// Greatest distance between two corners; of many corners a bound, twice the greatest from the first.
double size_of(std::span<const ClipPoint> polygon) {
    constexpr std::size_t few = 4;
    const bool many = polygon.size() > few;
    double greatest = 0.0;
    for (std::size_t i = 0; i < (many ? 1 : polygon.size()); ++i) {
        for (std::size_t k = i + 1; k < polygon.size(); ++k) {
            const Vec3d apart = position(polygon[k]) - position(polygon[i]);
            greatest = std::max(greatest, glm::dot(apart, apart));
        }
    }
    return (many ? 2.0 : 1.0) * std::sqrt(greatest);
}

/// Bounds of the range over the face: corners are farthest; nothing is nearer than the plane, nor than the farthest
/// corner less the face's size.
void bound_range(std::span<const ClipPoint> polygon, double plane_distance_m, DepthPlane& plane) {
    double farthest = 0.0;
    for (const ClipPoint& p : polygon) {
        if (p.w == 0.0) {
            plane.nearest_m = plane_distance_m;
            plane.farthest_m = std::numeric_limits<double>::infinity();
            return;
        }
        farthest = std::max(farthest, glm::dot(position(p), position(p)));
    }
    plane.farthest_m = std::sqrt(farthest);
    plane.nearest_m = std::max(plane_distance_m, plane.farthest_m - size_of(polygon));
}

} // namespace

DepthPlane depth_plane(const View& view, std::span<const ClipPoint> polygon) {
    DepthPlane plane{.nearest_m = std::numeric_limits<double>::infinity(),
                     .farthest_m = std::numeric_limits<double>::infinity()};
    const auto base =
        std::find_if(polygon.begin(), polygon.end(), [](const ClipPoint& p) { return p.w != 0.0; });
    if (base == polygon.end()) return plane;
    const Vec3d normal = normal_of(polygon, *base);
    const double offset = glm::dot(normal, position(*base));
    const double length = std::sqrt(glm::dot(normal, normal));
    if (std::fabs(offset) <= 1e-9 * length) return plane;
    // n.(x, y, z) = offset with x = z * tx, y = z * ty: 1/z = (n.x * tx + n.y * ty + n.z) / offset.
    const Vec3d inverse = normal * (1.0 / offset);
    const double per_column = inverse.x * 256.0 / view.scale.x_scale;
    const double per_row = inverse.y * 256.0 / view.scale.y_scale;
    plane.inverse_m = inverse.x * (128.0 - view.scale.x_offset) / view.scale.x_scale +
                      inverse.y * (128.0 - view.scale.y_offset) / view.scale.y_scale + inverse.z;
    plane.across = view.vertical ? per_column : per_row;
    plane.along = view.vertical ? per_row : per_column;
    bound_range(polygon, std::fabs(offset) / length, plane);
    return plane;
}

} // namespace linkdig::ig
