#include "database/compiler/splitting_plane.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace linkdig::database {

namespace {

/// Candidates looked at: each is tried against every face of the set.
constexpr std::size_t most_candidates = 600;
/// Sets up to here are split with the fewest cuts whatever the balance; in larger ones an uneven tree costs
/// more than a few cuts.
constexpr std::size_t small_set = 64;
constexpr std::size_t price_of_cut = 4;

Plane as_stored(const Vec3d& normal, double distance) {
    return {rounded_to_float(normal), rounded_to_float(distance)};
}

struct Split {
    std::size_t front = 0, on = 0, back = 0, cut = 0;
};

Split try_plane(std::span<const OrderFace> faces, const Plane& plane, double tolerance) {
    Split split;
    for (const OrderFace& face : faces) {
        const Sides sides = sides_of(face, plane, tolerance);
        split.front += sides.front ? 1 : 0;
        split.back += sides.back ? 1 : 0;
        split.cut += sides.front && sides.back ? 1 : 0;
        split.on += !sides.front && !sides.back ? 1 : 0;
    }
    return split;
}

using Cost = std::tuple<std::size_t, std::size_t>; ///< lower is better

Cost cost_of(const Split& split, std::size_t size) {
    const std::size_t larger = std::max(split.front, split.back);
    if (size <= small_set) return {split.cut, larger};
    return {price_of_cut * split.cut + larger, 0};
}

class Candidates {
public:
    Candidates(std::span<const OrderFace> faces, double tolerance) : faces_(faces), tolerance_(tolerance) {}

    void offer(const Plane& plane) {
        const Split split = try_plane(faces_, plane, tolerance_);
        if (std::max({split.front, split.back, split.on}) >= faces_.size()) return;
        const Cost cost = cost_of(split, faces_.size());
        if (found_ && cost >= best_cost_) return;
        found_ = true;
        best_ = plane;
        best_cost_ = cost;
    }
    bool found() const { return found_; }
    std::optional<Plane> best() const {
        if (!found_) return std::nullopt;
        return best_;
    }

private:
    std::span<const OrderFace> faces_;
    double tolerance_;
    bool found_ = false;
    Plane best_;
    Cost best_cost_{};
};

/// Coordinates of the faces' borders on an axis, ascending, each once.
std::vector<double> borders(std::span<const OrderFace> faces, int axis) {
    std::vector<double> all;
    for (const OrderFace& face : faces) {
        double low = 0, high = 0;
        bool any = false;
        for (const OrderCorner& corner : face.corners) {
            if (corner.position.w == 0) continue;
            low = any ? std::min(low, corner.position[axis]) : corner.position[axis];
            high = any ? std::max(high, corner.position[axis]) : corner.position[axis];
            any = true;
        }
        if (any) all.insert(all.end(), {low, high});
    }
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
}

Plane axis_plane(int axis, double distance) {
    Vec3d normal(0.0);
    normal[axis] = 1.0;
    return {normal, distance};
}

} // namespace

double split_tolerance(std::span<const OrderFace> faces) {
    double largest = 0;
    for (const OrderFace& face : faces)
        for (const OrderCorner& corner : face.corners)
            for (int axis = 0; axis < 3 && corner.position.w != 0; ++axis)
                largest = std::max(largest, std::fabs(corner.position[axis]));
    return std::max(plane_tolerance_m, 1e-6 * largest); // a float's normal errs by 6e-8, so does its distance
}

std::optional<Plane> splitting_plane(std::span<const OrderFace> faces, double tolerance) {
    Candidates candidates(faces, tolerance);
    const std::size_t face_step = 1 + faces.size() / (most_candidates / 2);
    for (std::size_t i = 0; i < faces.size(); i += face_step)
        if (!faces[i].at_infinity && !faces[i].is_light)
            candidates.offer(as_stored(faces[i].plane.normal, faces[i].plane.distance));
    for (int axis = 0; axis < 3; ++axis) {
        const std::vector<double> all = borders(faces, axis);
        const std::size_t step = 1 + all.size() / (most_candidates / 6);
        for (std::size_t i = 0; i < all.size(); i += step)
            candidates.offer(axis_plane(axis, all[i]));
    }
    if (!candidates.found() && face_step > 1) // the sample may have missed the one that helps
        for (const OrderFace& face : faces)
            if (!face.at_infinity && !face.is_light && !candidates.found())
                candidates.offer(as_stored(face.plane.normal, face.plane.distance));
    return candidates.best();
}

} // namespace linkdig::database
