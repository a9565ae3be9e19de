#include "database/compiler/ordering.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace linkdig::database {

namespace {

/// Cosine beyond which two planes count as one direction: then layers may decide.
constexpr double parallel_cosine = 0.99;

} // namespace

void bound(OrderFace& face) {
    Vec3d low(0.0), high(0.0);
    bool first = true;
    face.radius = 0;
    for (const OrderCorner& corner : face.corners) {
        if (corner.position.w == 0) {
            face.radius = std::numeric_limits<double>::infinity();
            continue;
        }
        const Vec3d p(corner.position);
        low = first ? p : glm::min(low, p);
        high = first ? p : glm::max(high, p);
        first = false;
    }
    face.centre = 0.5 * (low + high);
    for (const OrderCorner& corner : face.corners)
        if (corner.position.w != 0)
            face.radius = std::max(face.radius, glm::distance(face.centre, Vec3d(corner.position)));
}

Sides sides_of(const OrderFace& face, const Plane& plane, double tolerance) {
    const double centre = glm::dot(plane.normal, face.centre) - plane.distance;
    if (centre > face.radius + tolerance) return {true, false};
    if (centre < -face.radius - tolerance) return {false, true};
    Sides sides;
    for (const OrderCorner& corner : face.corners) {
        const double side = side_of(plane, corner.position);
        const double least = corner.position.w == 0 ? direction_tolerance : tolerance;
        sides.front = sides.front || side > least;
        sides.back = sides.back || side < -least;
    }
    return sides;
}

namespace {

/// Of b against the plane of a. Before the plane at infinity lies whatever has a point that is not.
Sides sides_against(const OrderFace& b, const OrderFace& a) {
    if (!a.at_infinity) return sides_of(b, a.plane, a.tolerance);
    return {!b.at_infinity, false};
}

std::vector<Vec4d> positions_of(const OrderFace& face) {
    std::vector<Vec4d> positions;
    positions.reserve(face.corners.size());
    for (const OrderCorner& corner : face.corners)
        positions.push_back(corner.position);
    return positions;
}

/// Sky faces as polygons in the plane one unit before the eye, in the direction of `a`.
bool overlap_in_sky(const OrderFace& a, const OrderFace& b) {
    const auto central = [&](const OrderFace& face, bool& behind) {
        std::vector<Vec4d> points;
        for (const OrderCorner& corner : face.corners) {
            const double along = -glm::dot(a.plane.normal, Vec3d(corner.position));
            behind = behind || along < planar_part;
            points.push_back(behind ? corner.position : Vec4d(Vec3d(corner.position) / along, 1.0));
        }
        return points;
    };
    bool behind = false;
    const std::vector<Vec4d> first = central(a, behind);
    const std::vector<Vec4d> second = central(b, behind);
    // One that reaches behind the other's half of the sky: the convex pieces of a dome do not.
    return !behind && overlap_in_plane(first, second, a.plane.normal);
}

bool overlap(const OrderFace& a, const OrderFace& b) {
    if (a.at_infinity) return overlap_in_sky(a, b);
    if (glm::distance(a.centre, b.centre) > a.radius + b.radius) return false;
    return overlap_in_plane(positions_of(a), positions_of(b), a.plane.normal);
}

/// One lies in the other's plane, and both are seen from one side: layers decide.
Relation relation_of_layers(const OrderFace& a, const OrderFace& b, bool coplanar) {
    if (!coplanar || a.at_infinity != b.at_infinity) return Relation::none;
    const double cosine = glm::dot(a.plane.normal, b.plane.normal);
    const bool same_way = a.at_infinity || cosine > parallel_cosine;
    const bool either_way = cosine < -parallel_cosine && (a.two_sided || b.two_sided);
    if ((!same_way && !either_way) || !overlap(a, b)) return Relation::none;
    if (a.layer == b.layer && a.of_mesh && b.of_mesh && a.source != b.source)
        return a.source > b.source ? Relation::first_hides : Relation::second_hides;
    if (a.layer == b.layer) return Relation::tie;
    return a.layer > b.layer ? Relation::first_hides : Relation::second_hides;
}

Relation relation_of_levels(const OrderFace& a, const OrderFace& b) {
    const bool together =
        a.levels == Levels::blended && std::max(a.level, b.level) - std::min(a.level, b.level) == 1;
    if (!together) return Relation::none;
    return a.level < b.level ? Relation::first_hides : Relation::second_hides;
}

/// A light point must come after what hides it, and before what it is seen against.
Relation relation_of_light(const OrderFace& light, const OrderFace& face) {
    if (face.at_infinity) return Relation::first_hides;
    const Sides face_of_light =
        light.directed ? sides_of(face, light.plane, light.tolerance) : Sides{true, true};
    const double side = side_of(face.plane, light.corners.front().position);
    const bool behind = side < -face.tolerance;
    const bool before = side > face.tolerance;
    const bool hidden = face_of_light.front && (behind || (face.two_sided && before));
    const bool against = (face_of_light.back || !face_of_light.front) && (!behind || face.two_sided);
    if (hidden && against) return Relation::both_hide;
    if (hidden) return Relation::second_hides;
    return against ? Relation::first_hides : Relation::none;
}

} // namespace

Relation relation(const OrderFace& a, const OrderFace& b) {
    if (a.slot != none && a.slot == b.slot && a.alternative != b.alternative) return Relation::none;
    if (a.source == b.source) return Relation::none; // parts of one face
    if (a.detail != none && a.detail == b.detail && a.level != b.level && a.levels != Levels::added)
        return relation_of_levels(a, b);
    if (a.is_light && b.is_light) return Relation::none;
    if (a.is_light) return relation_of_light(a, b);
    if (b.is_light) {
        const Relation mirrored = relation_of_light(b, a);
        return mirrored == Relation::first_hides    ? Relation::second_hides
               : mirrored == Relation::second_hides ? Relation::first_hides
                                                    : mirrored;
    }
    const Sides b_of_a = sides_against(b, a);
    const Sides a_of_b = sides_against(a, b);
    const bool a_before = a_of_b.front || (b.two_sided && a_of_b.back);
    const bool b_before = b_of_a.front || (a.two_sided && b_of_a.back);
    const bool b_beyond = b_of_a.back || (a.two_sided && b_of_a.front);
    const bool a_beyond = a_of_b.back || (b.two_sided && a_of_b.front);
    const bool first = b_beyond && a_before;
    const bool second = a_beyond && b_before;
    if (first && second) return Relation::both_hide;
    if (first) return Relation::first_hides;
    if (second) return Relation::second_hides;
    const bool coplanar = (!b_of_a.front && !b_of_a.back) || (!a_of_b.front && !a_of_b.back) || a.at_infinity;
    return relation_of_layers(a, b, coplanar);
}

} // namespace linkdig::database
