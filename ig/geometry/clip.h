#pragma once
/// Clips a convex polygon against one plane in homogeneous channel coordinates.
///
/// The new point of an edge is computed from its end points in canonical order, so that the two faces that
/// share the edge get the same bits. A plane is a linear function d(p) = a x + b y + c z + e w + constant,
/// inside where d >= 0.

#include <array>
#include <cstdint>
#include <vector>

namespace linkdig::ig {

/// A point in the channel frame; w = 0 lies at infinity. Intensity is 1.0 = 2^22, kept as a double while it
/// is cut.
struct ClipPoint {
    double x = 0, y = 0, z = 0, w = 1;
    double intensity = 0;
};

struct ClipPlane {
    double a = 0, b = 0, c = 0, e = 0, constant = 0;
    constexpr double operator()(const ClipPoint& p) const {
        return a * p.x + b * p.y + c * p.z + e * p.w + constant;
    }
};

/// Where the edge a-b meets the plane, given the distances of its ends (of opposite sign).
ClipPoint cut_edge(const ClipPoint& a, double distance_a, const ClipPoint& b, double distance_b);

/// Keeps the part of `polygon` inside the plane; `spare` is working storage.
void clip(std::vector<ClipPoint>& polygon, const ClipPlane& plane, std::vector<ClipPoint>& spare);

} // namespace linkdig::ig
