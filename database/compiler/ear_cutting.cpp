#include "database/compiler/ear_cutting.h"

#include <cmath>
#include <cstddef>
#include <numeric>

namespace linkdig::database {

namespace {

/// The polygon on the coordinate plane that it faces most, counter-clockwise.
std::vector<Vec2d> flattened(std::span<const Vec3d> corners) {
    Vec3d area(0.0);
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
        area += glm::cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
    const Vec3d size = glm::abs(area);
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const int u = area[axis] >= 0 ? (axis + 1) % 3 : (axis + 2) % 3;
    const int v = area[axis] >= 0 ? (axis + 2) % 3 : (axis + 1) % 3;
    std::vector<Vec2d> flat;
    for (const Vec3d& corner : corners)
        flat.emplace_back(corner[u], corner[v]);
    return flat;
}

double turn(const Vec2d& a, const Vec2d& b, const Vec2d& c) {
    return (b.x - a.x) * (c.y - b.y) - (b.y - a.y) * (c.x - b.x);
}

bool inside(const Vec2d& p, const Vec2d& a, const Vec2d& b, const Vec2d& c) {
    return turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0 && p != a && p != b && p != c;
}

/// Does the corner at `i` of those left stick out, with none of the others inside?
bool is_ear(const std::vector<Vec2d>& flat, const std::vector<std::uint32_t>& left, std::size_t i) {
    const std::size_t n = left.size();
    const Vec2d& a = flat[left[(i + n - 1) % n]];
    const Vec2d& b = flat[left[i]];
    const Vec2d& c = flat[left[(i + 1) % n]];
    if (turn(a, b, c) <= 0) return false;
    for (std::size_t k = 2; k + 1 < n; ++k)
        if (inside(flat[left[(i + k) % n]], a, b, c)) return false;
    return true;
}

} // namespace

std::vector<std::array<std::uint32_t, 3>> cut_ears(std::span<const Vec3d> corners) {
    const std::vector<Vec2d> flat = flattened(corners);
    std::vector<std::uint32_t> left(corners.size());
    std::iota(left.begin(), left.end(), 0U);
    std::vector<std::array<std::uint32_t, 3>> triangles;
    while (left.size() > 2) {
        std::size_t ear = 0;
        while (ear < left.size() && !is_ear(flat, left, ear))
            ++ear;
        if (ear == left.size()) ear = 1; // none: it intersects itself, or has no area
        const std::size_t n = left.size();
        triangles.push_back({left[(ear + n - 1) % n], left[ear], left[(ear + 1) % n]});
        left.erase(left.begin() + static_cast<std::ptrdiff_t>(ear));
    }
    return triangles;
}

} // namespace linkdig::database
