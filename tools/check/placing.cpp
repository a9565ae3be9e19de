#include "tools/check/placing.h"

#include "tools/check/views.h"

#include "database/model/units.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace linkdig::tools {
namespace {

constexpr double clear_m = 4.0; ///< between two footprints
constexpr int places_tried = 200;

/// A thing's outline on the ground: a turned rectangle.
struct Footprint {
    Vec2d centre{0};
    Vec2d along{1, 0};
    Vec2d half{0};
    double reach_m() const { return glm::length(half); }
};

Footprint footprint(const Thing& thing, const MovingObject& at) {
    const Mat3d turn = world_from_body({.heading_rad = at.waterline_heading_rad});
    const Vec3d centre = at.waterline_position_m + turn * thing.centre_m();
    return {{centre.x, centre.y}, {turn[0].x, turn[0].y}, 0.5 * Vec2d(thing.high_m - thing.low_m)};
}

double shadow(const Footprint& f, const Vec2d& axis) {
    return std::fabs(glm::dot(axis, f.along)) * f.half.x +
           std::fabs(glm::dot(axis, Vec2d(-f.along.y, f.along.x))) * f.half.y;
}

bool apart(const Footprint& a, const Footprint& b) {
    const Vec2d axes[] = {a.along, Vec2d(-a.along.y, a.along.x), b.along, Vec2d(-b.along.y, b.along.x)};
    return std::ranges::any_of(axes, [&](const Vec2d& axis) {
        return std::fabs(glm::dot(axis, b.centre - a.centre)) > shadow(a, axis) + shadow(b, axis) + clear_m;
    });
}

MovingObject pose(const Vec2d& position, RandomStream& random) {
    MovingObject object;
    object.waterline_position_m = {position.x, position.y, 0.0};
    object.waterline_heading_rad = random.between(0.0, two_pi);
    object.position_m = {position.x, position.y, random.between(-greatest_heave_m, greatest_heave_m)};
    object.attitude.heading_rad = object.waterline_heading_rad;
    object.attitude.pitch_rad = radians(random.between(-greatest_pitch_deg, greatest_pitch_deg));
    object.attitude.roll_rad = radians(random.between(-greatest_roll_deg, greatest_roll_deg));
    return object;
}

/// A place beside something that stands already, often close by, as ships pass each other.
MovingObject place_beside(const Thing& thing, const std::vector<Footprint>& standing, RandomStream& random) {
    MovingObject object = pose({0, 0}, random);
    for (int i = 0; i < places_tried && !standing.empty(); ++i) {
        const Footprint& other = standing[random.below(static_cast<std::uint32_t>(standing.size()))];
        const double reach = other.reach_m() + thing.radius_m() + clear_m;
        const double distance = random.between(0.1, 1.0 + 0.02 * i) * reach;
        const Vec3d way = direction(random.between(0.0, two_pi), 0.0);
        object = pose(other.centre + distance * Vec2d(way.x, way.y), random);
        const Footprint mine = footprint(thing, object);
        if (std::ranges::all_of(standing, [&](const Footprint& each) { return apart(mine, each); })) break;
    }
    return object;
}

void add(Thing& thing, bool& any, const Vec3d& point) {
    thing.low_m = any ? glm::min(thing.low_m, point) : point;
    thing.high_m = any ? glm::max(thing.high_m, point) : point;
    any = true;
}

} // namespace

std::vector<Thing> things_of(const VisualDatabase& database) {
    std::map<std::pair<std::int32_t, std::int32_t>, std::pair<Thing, bool>>
        found; // by moving object, cluster
    for (const Face& face : database.faces) {
        const ObjectList& list = database.lists[database.objects[face.object].list];
        if (list.attachment == Attachment::eye) continue;
        const Cluster& cluster = database.clusters[list.cluster];
        const std::int32_t moving = cluster.moving_object;
        const auto key = std::make_pair(moving, moving == none ? static_cast<std::int32_t>(list.cluster) : 0);
        auto& [thing, any] = found[key];
        thing.moving_object = moving;
        thing.name =
            moving == none ? cluster.name : database.moving_objects[static_cast<std::size_t>(moving)];
        for (std::uint32_t k = 0; k < face.corner_count; ++k) {
            const Vec4f& p = database.vertices[database.corners[face.first_corner + k]].position;
            if (p.w != 0.0F) add(thing, any, list.origin_m + Vec3d(p));
        }
    }
    std::vector<Thing> things;
    for (const auto& [key, entry] : found)
        if (entry.second) things.push_back(entry.first);
    return things;
}

std::vector<MovingObject> place_moving_objects(const VisualDatabase& database,
                                               const std::vector<Thing>& things, RandomStream& random) {
    std::vector<MovingObject> placed(database.moving_objects.size());
    std::vector<Footprint> standing;
    for (const Thing& thing : things)
        if (thing.moving_object == none) standing.push_back(footprint(thing, {}));
    for (const Thing& thing : things) {
        if (thing.moving_object == none) continue;
        MovingObject& object = placed[static_cast<std::size_t>(thing.moving_object)];
        object = place_beside(thing, standing, random);
        standing.push_back(footprint(thing, object));
    }
    return placed;
}

Vec3d in_world(const Thing& thing, const std::vector<MovingObject>& placed, const Vec3d& point_m) {
    if (thing.moving_object == none) return point_m;
    const MovingObject& object = placed[static_cast<std::size_t>(thing.moving_object)];
    return object.position_m + world_from_body(object.attitude) * point_m;
}

} // namespace linkdig::tools
