#include "tools/check/views.h"

#include "tools/check/cast_scene.h"
#include "tools/check/caster.h"
#include "tools/check/placing.h"

#include "database/model/units.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace linkdig::tools {
namespace {

constexpr std::array<const char*, 3> ranges{"near", "around", "far"};
constexpr int tries = 60;

struct Look {
    Vec3d eye_m{0};
    Vec3d aim_m{0};
    double half_field_rad = 0.5;
};

/// Something to look at in a database that has nothing finite: the place where the origin is.
Thing nothing_there() { return {.name = "the origin", .low_m = {-10, -10, 0}, .high_m = {10, 10, 10}}; }

/// In the thing's own frame.
Look near_look(const Thing& thing, RandomStream& random) {
    const Vec3d margin = 0.15 * (thing.high_m - thing.low_m) + Vec3d(3.0);
    Look look;
    look.eye_m = random.point(thing.low_m - margin, thing.high_m + margin);
    const Vec3d reach(std::min(60.0, std::max(5.0, 0.3 * thing.radius_m())));
    look.aim_m =
        random.point(glm::max(thing.low_m, look.eye_m - reach), glm::min(thing.high_m, look.eye_m + reach));
    look.half_field_rad = radians(random.between(20.0, 40.0));
    return look;
}

Look far_look(const Thing& thing, bool far, RandomStream& random) {
    Look look;
    const double azimuth = random.between(0.0, two_pi);
    const double elevation = radians(far ? random.between(0.5, 30.0) : random.between(-5.0, 80.0));
    const double distance = thing.radius_m() * (far ? random.between(3.0, 12.0) : random.between(1.05, 2.5));
    look.eye_m = thing.centre_m() + distance * direction(azimuth, elevation);
    look.aim_m =
        random.point(0.5 * (thing.low_m + thing.centre_m()), 0.5 * (thing.high_m + thing.centre_m()));
    look.half_field_rad =
        std::clamp(arc_tangent((far ? 1.0 : 0.7) * thing.radius_m(), distance), radians(1.0), radians(35.0));
    return look;
}

ChannelView channel_of(const Look& look, double roll_rad, double aspect) {
    ChannelView channel;
    channel.eye_m = look.eye_m;
    const Vec3d way = look.aim_m - look.eye_m;
    channel.attitude = {.heading_rad = arc_tangent(way.y, way.x),
                        .pitch_rad = arc_tangent(way.z, std::sqrt(way.x * way.x + way.y * way.y)),
                        .roll_rad = roll_rad};
    const double up = tangent(look.half_field_rad);
    channel.top_tangent = up;
    channel.bottom_tangent = -up;
    channel.right_tangent = up * aspect;
    channel.left_tangent = -up * aspect;
    return channel;
}

bool stands_free(const VisualDatabase& database, const FramePacket& packet, const Vec3d& eye_m) {
    const CastScene scene = cast_scene(database, packet, eye_m);
    return !Caster(scene).eye_is_inside();
}

} // namespace

CheckView check_view(const VisualDatabase& database, std::uint64_t seed, std::uint64_t number,
                     double aspect) {
    RandomStream random(random_bits(seed, number));
    std::vector<Thing> things = things_of(database);
    if (things.empty()) things.push_back(nothing_there());
    const Thing& thing = things[number % things.size()];
    const std::size_t range = number / things.size() % ranges.size();
    CheckView view{.number = number, .packet = {}, .target = thing.name, .range = ranges[range]};
    FramePacket& packet = view.packet;
    packet.frame = number;
    packet.discontinuity = true; // a view knows nothing of the one before
    packet.suns.assign(database.suns.size(), Vec3f(direction(random.between(0.0, two_pi), 0.7)));
    packet.moving_objects = place_moving_objects(database, things, random);
    for (std::uint32_t slot = 0; slot < database.slots.size(); ++slot)
        packet.substitutions.push_back({slot, random.below(database.slots[slot].alternatives)});
    for (int i = 0; i < tries; ++i) {
        Look look = range == 0 ? near_look(thing, random) : far_look(thing, range == 2, random);
        look.eye_m = in_world(thing, packet.moving_objects, look.eye_m);
        look.aim_m = in_world(thing, packet.moving_objects, look.aim_m);
        packet.channels = {channel_of(look, radians(random.between(-20.0, 20.0)), aspect)};
        if (glm::distance(look.eye_m, look.aim_m) > 0.1 && stands_free(database, packet, look.eye_m)) break;
    }
    return view;
}

} // namespace linkdig::tools
