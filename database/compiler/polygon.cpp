#include "database/compiler/polygon.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace linkdig::database {

namespace {

/// Substitutes of directions stand this many extents away.
constexpr double far_extents = 1e4;
/// Narrower faces have no area worth drawing: a tenth of the plane tolerance.
constexpr double least_width_m = 1e-4;
/// Sine of the turn that still counts as straight on.
constexpr double straight_sine = 1e-6;
/// Crossing edges are looked for, to name the fault, in polygons of at most this many corners.
constexpr std::size_t most_corners_searched = 1000;

double extent_of(std::span<const Vec3d> points) {
    Vec3d low = points.front();
    Vec3d high = low;
    for (const Vec3d& p : points) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    return glm::length(high - low);
}

/// Twice the area's vector (Newell). Relative to the first point, so that distant faces keep their digits.
Vec3d area_vector(std::span<const Vec3d> points) {
    Vec3d sum(0.0);
    for (std::size_t i = 1; i + 1 < points.size(); ++i)
        sum += glm::cross(points[i] - points[0], points[i + 1] - points[0]);
    return sum;
}

/// Of a polygon whose signed area vanishes: the plane of its largest triangle over the first edge-wide pair.
Vec3d largest_triangle(std::span<const Vec3d> points) {
    Vec3d best(0.0);
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
        const Vec3d area = glm::cross(points[i] - points[0], points[i + 1] - points[0]);
        if (glm::dot(area, area) > glm::dot(best, best)) best = area;
    }
    return best;
}

/// Coordinates in the plane with this normal, counter-clockwise kept.
std::vector<Vec2d> flattened(std::span<const Vec3d> points, const Vec3d& normal) {
    const Vec3d axis = std::fabs(normal.x) < 0.6 ? Vec3d(1, 0, 0) : Vec3d(0, 1, 0);
    const Vec3d u = glm::normalize(glm::cross(axis, normal));
    const Vec3d v = glm::cross(normal, u);
    std::vector<Vec2d> flat;
    flat.reserve(points.size());
    for (const Vec3d& p : points)
        flat.emplace_back(glm::dot(u, p - points[0]), glm::dot(v, p - points[0]));
    return flat;
}

double cross2(const Vec2d& a, const Vec2d& b) { return a.x * b.y - a.y * b.x; }

bool edges_cross(const Vec2d& a, const Vec2d& b, const Vec2d& c, const Vec2d& d) {
    const double c_side = cross2(b - a, c - a);
    const double d_side = cross2(b - a, d - a);
    const double a_side = cross2(d - c, a - c);
    const double b_side = cross2(d - c, b - c);
    return c_side * d_side < 0 && a_side * b_side < 0;
}

bool any_edges_cross(const std::vector<Vec2d>& flat) {
    const std::size_t n = flat.size();
    if (n > most_corners_searched) return false;
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = i + 2; j < n; ++j)
            if (edges_cross(flat[i], flat[(i + 1) % n], flat[j], flat[(j + 1) % n])) return true;
    return false;
}

/// Convex: no turn to the right, and once around.
void check_turns(const std::vector<Vec2d>& flat, PolygonReport& report) {
    const std::size_t n = flat.size();
    int reversals = 0;
    double last = 0;
    for (std::size_t pass = 0; pass < 2 * n;
         ++pass) { // the second round counts, the first only settles `last`
        const double dx = flat[(pass + 1) % n].x - flat[pass % n].x;
        if (dx == 0) continue;
        if (pass >= n && last * dx < 0) ++reversals;
        last = dx;
    }
    for (std::size_t i = 0; i < n; ++i) {
        const Vec2d in = flat[i] - flat[(i + n - 1) % n];
        const Vec2d out = flat[(i + 1) % n] - flat[i];
        const double turn = cross2(in, out);
        const double scale = glm::length(in) * glm::length(out);
        const bool back = std::fabs(turn) <= straight_sine * scale && glm::dot(in, out) < 0;
        if (turn >= -straight_sine * scale && !back) continue;
        report.fault = PolygonFault::concave;
        report.corner = i;
        break;
    }
    if (report.fault == PolygonFault::none && reversals > 2) report.fault = PolygonFault::self_intersecting;
}

void check_shape(std::span<const Vec3d> points, double extent, PolygonReport& report) {
    Vec3d area = area_vector(points);
    const double least_area = 2 * least_width_m * extent;
    const Vec3d triangle = largest_triangle(points);
    if (glm::length(triangle) < least_area) {
        report.fault = PolygonFault::zero_area;
        return;
    }
    const bool cancels = glm::length(area) < least_area;
    if (cancels) area = triangle;
    report.plane.normal = glm::normalize(area);
    const std::vector<Vec2d> flat = flattened(points, report.plane.normal);
    check_turns(flat, report);
    if (report.fault != PolygonFault::none && any_edges_cross(flat))
        report.fault = PolygonFault::self_intersecting;
    if (report.fault == PolygonFault::none && cancels) report.fault = PolygonFault::zero_area;
}

/// The plane through the mean of the points; the deviation of points in metres, of directions in
/// `allowed_m`s.
void fit_plane(std::span<const Vec4d> corners, double extent, PolygonReport& report) {
    Vec3d mean(0.0);
    double points = 0;
    for (const Vec4d& corner : corners) {
        if (corner.w == 0) continue;
        mean += Vec3d(corner);
        points += 1;
    }
    report.plane.distance = glm::dot(report.plane.normal, mean / points);
    report.allowed_m = std::max(plane_tolerance_m, planar_part * extent);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const double scale = corners[i].w == 0 ? report.allowed_m / planar_part : 1.0;
        const double off = std::fabs(side_of(report.plane, corners[i])) * scale;
        if (off <= report.deviation_m) continue;
        report.deviation_m = off;
        report.corner = i;
    }
}

/// Every corner is a direction: the polygon is convex if each edge's great circle keeps all others on one
/// side.
PolygonReport examine_sky(std::span<const Vec4d> corners) {
    PolygonReport report;
    report.at_infinity = true;
    Vec3d sum(0.0);
    for (const Vec4d& corner : corners)
        sum += Vec3d(corner);
    if (glm::length(sum) < direction_tolerance) {
        report.fault = PolygonFault::zero_area;
        return report;
    }
    report.plane.normal = -glm::normalize(sum);
    std::vector<Vec3d> flat;
    for (const Vec4d& corner : corners) {
        const double along = -glm::dot(report.plane.normal, Vec3d(corner));
        if (along < planar_part) { // reaches around more than half of the sky
            report.fault = PolygonFault::concave;
            return report;
        }
        flat.push_back(Vec3d(corner) / along);
    }
    const Vec3d towards_eye = report.plane.normal;
    check_shape(flat, extent_of(flat), report);
    if (report.fault == PolygonFault::none && glm::dot(report.plane.normal, towards_eye) < 0)
        report.fault = PolygonFault::concave; // clockwise seen from inside: it would never be seen
    report.plane = {towards_eye, 0.0};
    return report;
}

} // namespace

std::vector<Vec3d> far_substitutes(std::span<const Vec4d> corners) {
    std::vector<Vec3d> points;
    for (const Vec4d& corner : corners)
        if (corner.w != 0) points.emplace_back(corner);
    if (points.empty()) points.emplace_back(0.0, 0.0, 0.0);
    const double distance = far_extents * std::max(1.0, extent_of(points));
    const Vec3d origin = points.front();
    std::vector<Vec3d> result;
    result.reserve(corners.size());
    for (const Vec4d& corner : corners)
        result.push_back(corner.w != 0 ? Vec3d(corner) : origin + distance * Vec3d(corner));
    return result;
}

PolygonReport examine(std::span<const Vec4d> corners) {
    const bool sky = std::all_of(corners.begin(), corners.end(), [](const Vec4d& c) { return c.w == 0; });
    if (sky) return examine_sky(corners);
    PolygonReport report;
    std::vector<Vec3d> finite;
    for (const Vec4d& corner : corners)
        if (corner.w != 0) finite.emplace_back(corner);
    const double extent = extent_of(finite);
    const std::vector<Vec3d> points = far_substitutes(corners);
    check_shape(points, finite.size() == points.size() ? extent : std::max(1.0, extent), report);
    if (report.fault == PolygonFault::zero_area) return report;
    const PolygonFault shape_fault = report.fault;
    const std::size_t shape_corner = report.corner;
    fit_plane(corners, extent, report);
    if (report.deviation_m > report.allowed_m)
        report.fault =
            PolygonFault::not_planar; // told first: seen in a plane that it has not, it may look concave
    else if (shape_fault != PolygonFault::none)
        report.corner = shape_corner;
    return report;
}

namespace {

/// Is there an edge of `a` beyond which `b` lies entirely?
bool separated(const std::vector<Vec2d>& a, const std::vector<Vec2d>& b) {
    for (std::size_t i = 0; i < a.size(); ++i) {
        const Vec2d edge = a[(i + 1) % a.size()] - a[i];
        const double length = glm::length(edge);
        if (length == 0) continue;
        double deepest = -1e300;
        for (const Vec2d& p : b)
            deepest = std::max(deepest, cross2(edge, p - a[i]) / length);
        if (deepest <= plane_tolerance_m) return true;
    }
    return false;
}

} // namespace

bool overlap_in_plane(std::span<const Vec4d> a, std::span<const Vec4d> b, const Vec3d& normal) {
    std::vector<Vec3d> points = far_substitutes(a);
    const std::vector<Vec3d> others = far_substitutes(b);
    points.insert(points.end(), others.begin(), others.end());
    const std::vector<Vec2d> flat = flattened(points, normal);
    const auto border = flat.begin() + static_cast<std::ptrdiff_t>(a.size());
    const auto counter_clockwise = [](std::vector<Vec2d> polygon) {
        double area = 0;
        for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
            area += cross2(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]);
        if (area < 0) std::reverse(polygon.begin(), polygon.end());
        return polygon;
    };
    const std::vector<Vec2d> first = counter_clockwise({flat.begin(), border});
    const std::vector<Vec2d> second = counter_clockwise({border, flat.end()});
    return !separated(first, second) && !separated(second, first);
}

} // namespace linkdig::database
