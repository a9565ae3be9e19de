#include "database/compiler/cutting.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace linkdig::database {

namespace {

/// Cuts of one edge closer than this part of it are one point.
constexpr double same_cut = 1e-7;
/// Weight below which a point between a corner and a direction stands at infinity itself.
constexpr double least_weight = 1e-9;

Vec4d as_stored(const Vec4d& homogeneous) {
    if (std::fabs(homogeneous.w) > least_weight) return as_float(Vec3d(homogeneous) / homogeneous.w);
    Vec4d direction = as_float(glm::normalize(Vec3d(homogeneous)));
    direction.w = 0;
    return direction;
}

OrderCorner between(const OrderCorner& a, const OrderCorner& b, const Vec4d& position, std::uint32_t point) {
    double part = 0.5; // on the way to infinity no intensity can be told
    if (a.position.w != 0 && b.position.w != 0) {
        const double length = glm::distance(Vec3d(a.position), Vec3d(b.position));
        if (length > 0) part = std::min(1.0, glm::distance(Vec3d(a.position), Vec3d(position)) / length);
    }
    return {position, a.normal + part * (b.normal - a.normal), a.colour + part * (b.colour - a.colour),
            point};
}

} // namespace

std::size_t EdgePoints::PlaceHash::operator()(const Place& place) const {
    std::uint64_t hash = 0;
    for (const double coordinate : place) {
        hash = (hash ^ std::bit_cast<std::uint64_t>(coordinate)) * 0x9E3779B97F4A7C15U;
        hash ^= hash >> 32U;
    }
    return hash;
}

std::uint32_t EdgePoints::point(const Vec4d& position) {
    // Adding nothing makes one zero of the two that a double has.
    const Place key{position.x + 0.0, position.y + 0.0, position.z + 0.0, position.w};
    const auto [found, is_new] = index_.emplace(key, static_cast<std::uint32_t>(positions_.size()));
    if (is_new) {
        positions_.push_back(position);
        made_on_.emplace_back();
    }
    return found->second;
}

EdgePoints::Edge EdgePoints::root_edge(std::uint32_t a, std::uint32_t b) const {
    const auto on = [](const Edge& edge, std::uint32_t p, const std::optional<Edge>& made) {
        return edge.first == p || edge.second == p || (made && *made == edge);
    };
    if (made_on_[a] && on(*made_on_[a], b, made_on_[b])) return *made_on_[a];
    if (made_on_[b] && on(*made_on_[b], a, made_on_[a])) return *made_on_[b];
    return std::minmax(a, b);
}

double EdgePoints::part_of(const Edge& edge, std::uint32_t point) const {
    if (point == edge.first) return 0.0;
    if (point == edge.second) return 1.0;
    for (const Cut& each : cuts_.at(edge))
        if (each.point == point) return each.part;
    return 0.0; // not reached: root_edge found the point there
}

std::uint32_t EdgePoints::cut(const Edge& edge, const Plane& plane) {
    const Vec4d low = positions_[edge.first];
    const Vec4d high = positions_[edge.second];
    const double low_side = side_of(plane, low);
    const double part = low_side / (low_side - side_of(plane, high));
    std::vector<Cut>& cuts = cuts_[edge];
    for (const Cut& each : cuts)
        if (std::fabs(each.part - part) < same_cut) return each.point;
    const Vec4d position = as_stored(low + part * (high - low));
    const std::uint32_t made = point(position);
    if (!made_on_[made] && made != edge.first && made != edge.second && made + 1 == positions_.size())
        made_on_[made] = edge;
    const auto after =
        std::find_if(cuts.begin(), cuts.end(), [&](const Cut& each) { return each.part > part; });
    cuts.insert(after, {part, made});
    return made;
}

OrderCorner EdgePoints::cross(const OrderCorner& a, const OrderCorner& b, const Plane& plane) {
    const std::uint32_t made = cut(root_edge(a.point, b.point), plane);
    return between(a, b, positions_[made], made);
}

void EdgePoints::join(OrderFace& face) const {
    if (cuts_.empty()) return;
    // An inserted point may end an edge that was cut on its own account.
    for (std::size_t before = 0; before != face.corners.size();) {
        before = face.corners.size();
        join_edges(face);
    }
}

void EdgePoints::join_edges(OrderFace& face) const {
    std::vector<OrderCorner> joined;
    for (std::size_t i = 0; i < face.corners.size(); ++i) {
        const OrderCorner& a = face.corners[i];
        const OrderCorner& b = face.corners[(i + 1) % face.corners.size()];
        joined.push_back(a);
        const Edge edge = root_edge(a.point, b.point);
        const auto found = cuts_.find(edge);
        if (found == cuts_.end()) continue;
        std::vector<Cut> inner;
        const double from = part_of(edge, a.point);
        const double to = part_of(edge, b.point);
        for (const Cut& each : found->second)
            if (each.part > std::min(from, to) && each.part < std::max(from, to) && each.point != a.point &&
                each.point != b.point)
                inner.push_back(each);
        if (from > to) std::reverse(inner.begin(), inner.end());
        for (const Cut& each : inner)
            joined.push_back(between(a, b, positions_[each.point], each.point));
    }
    face.corners = std::move(joined);
}

namespace {

int side_sign(const OrderCorner& corner, const Plane& plane, double tolerance) {
    const double side = side_of(plane, corner.position);
    const double least = corner.position.w == 0 ? direction_tolerance : tolerance;
    return side > least ? 1 : side < -least ? -1 : 0;
}

/// The part of the face on one side (+1, -1) of the plane.
OrderFace half(const OrderFace& face, const std::vector<int>& signs, int side, const Plane& plane,
               EdgePoints& points) {
    OrderFace part = face;
    part.corners.clear();
    const std::size_t n = face.corners.size();
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t next = (i + 1) % n;
        if (signs[i] != -side) part.corners.push_back(face.corners[i]);
        if (signs[i] * signs[next] < 0)
            part.corners.push_back(points.cross(face.corners[i], face.corners[next], plane));
    }
    bound(part);
    return part;
}

} // namespace

Halves cut_face(OrderFace face, const Plane& plane, double tolerance, EdgePoints& points) {
    std::vector<int> signs;
    for (const OrderCorner& corner : face.corners)
        signs.push_back(side_sign(corner, plane, tolerance));
    const bool front = std::find(signs.begin(), signs.end(), 1) != signs.end();
    const bool back = std::find(signs.begin(), signs.end(), -1) != signs.end();
    Halves halves;
    if (front && back) {
        halves.faces = {half(face, signs, 1, plane, points), half(face, signs, -1, plane, points)};
        halves.front = 0;
        halves.back = 1;
        return halves;
    }
    halves.faces.push_back(std::move(face));
    (front ? halves.front : back ? halves.back : halves.on) = 0;
    return halves;
}

} // namespace linkdig::database
