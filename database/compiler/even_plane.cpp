#include "database/compiler/splitting_plane.h"

#include <algorithm>
#include <array>
#include <limits>

namespace linkdig::database {

namespace {

constexpr std::size_t price_of_cut = 4;

/// Where each face begins and ends on an axis, each sorted by itself. A face with a corner at infinity has
/// neither: every plane counts as cutting it.
struct Borders {
    std::vector<double> low, high;
};

Borders borders_on(std::span<const OrderFace> faces, int axis) {
    Borders borders;
    borders.low.reserve(faces.size());
    borders.high.reserve(faces.size());
    for (const OrderFace& face : faces) {
        double low = std::numeric_limits<double>::infinity();
        double high = -low;
        bool infinite = false;
        for (const OrderCorner& corner : face.corners) {
            infinite = infinite || corner.position.w == 0;
            low = std::min(low, corner.position[axis]);
            high = std::max(high, corner.position[axis]);
        }
        borders.low.push_back(infinite ? -std::numeric_limits<double>::infinity() : low);
        borders.high.push_back(infinite ? std::numeric_limits<double>::infinity() : high);
    }
    std::sort(borders.low.begin(), borders.low.end());
    std::sort(borders.high.begin(), borders.high.end());
    return borders;
}

struct Candidate {
    double distance = 0;
    std::size_t cuts = 0; ///< as long as no face lies on the plane; else fewer
    std::size_t cost = std::numeric_limits<std::size_t>::max();
};

/// Of the planes at the faces' ends.
Candidate best_on(const Borders& borders, double tolerance) {
    const std::size_t n = borders.low.size();
    Candidate best;
    std::size_t begun = 0, ended = 0; // faces with a part behind the plane; faces with none in front of it
    for (std::size_t i = 0; i < n; ++i) {
        const double distance = borders.high[i];
        if (distance == std::numeric_limits<double>::infinity()) break;
        if (i > 0 && distance == borders.high[i - 1]) continue;
        while (begun < n && borders.low[begun] < distance - tolerance)
            ++begun;
        while (ended < n && borders.high[ended] <= distance + tolerance)
            ++ended;
        const std::size_t in_front = n - ended;
        const std::size_t cuts = begun + in_front > n ? begun + in_front - n : 0;
        const std::size_t on_plane = n + cuts - begun - in_front;
        const std::size_t larger = std::max({begun, in_front, on_plane});
        if (larger >= n) continue;
        const std::size_t cost = price_of_cut * cuts + larger;
        if (cost < best.cost) best = {distance, cuts, cost};
    }
    return best;
}

/// The axes, those along which the set is longest first: they are the likeliest to divide it.
std::array<int, 3> axes_by_extent(std::span<const OrderFace> faces) {
    Vec3d low(std::numeric_limits<double>::max());
    Vec3d high = -low;
    for (const OrderFace& face : faces) {
        low = glm::min(low, face.centre);
        high = glm::max(high, face.centre);
    }
    std::array<int, 3> axes{0, 1, 2};
    std::stable_sort(axes.begin(), axes.end(),
                     [&](int a, int b) { return high[a] - low[a] > high[b] - low[b]; });
    return axes;
}

} // namespace

std::optional<EvenPlane> even_plane(std::span<const OrderFace> faces, double tolerance) {
    Candidate best;
    int best_axis = 0;
    for (const int axis : axes_by_extent(faces)) {
        const Candidate found = best_on(borders_on(faces, axis), tolerance);
        if (found.cost >= best.cost) continue;
        best = found;
        best_axis = axis;
        if (best.cuts == 0 && best.cost <= faces.size() - faces.size() / 3)
            break; // good enough to look no further
    }
    if (best.cost == std::numeric_limits<std::size_t>::max()) return std::nullopt;
    Vec3d normal(0.0);
    normal[best_axis] = 1.0;
    const Plane plane{normal, rounded_to_float(best.distance)};
    const auto cut = [&](const OrderFace& face) {
        const Sides sides = sides_of(face, plane, tolerance);
        return sides.front && sides.back;
    };
    return EvenPlane{plane, std::any_of(faces.begin(), faces.end(), cut)};
}

} // namespace linkdig::database
