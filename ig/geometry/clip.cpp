#include "ig/geometry/clip.h"

#include <tuple>

namespace linkdig::ig {

ClipPoint cut_edge(const ClipPoint& a, double distance_a, const ClipPoint& b, double distance_b) {
    if (std::tie(b.x, b.y, b.z, b.w) < std::tie(a.x, a.y, a.z, a.w))
        return cut_edge(b, distance_b, a, distance_a);
    const double t = distance_a / (distance_a - distance_b);
    const auto mix = [t](double from, double to) { return from + t * (to - from); };
    return {mix(a.x, b.x), mix(a.y, b.y), mix(a.z, b.z), mix(a.w, b.w), mix(a.intensity, b.intensity)};
}

void clip(std::vector<ClipPoint>& polygon, const ClipPlane& plane, std::vector<ClipPoint>& spare) {
    spare.clear();
    const std::size_t count = polygon.size();
    for (std::size_t k = 0; k < count; ++k) {
        const ClipPoint& from = polygon[k];
        const ClipPoint& to = polygon[k + 1 == count ? 0 : k + 1];
        const double distance_from = plane(from);
        const double distance_to = plane(to);
        if (distance_from >= 0.0) spare.push_back(from);
        if ((distance_from >= 0.0) != (distance_to >= 0.0)) {
            spare.push_back(cut_edge(from, distance_from, to, distance_to));
        }
    }
    polygon.swap(spare);
}

} // namespace linkdig::ig
