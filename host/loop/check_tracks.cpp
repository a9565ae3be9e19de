#include "host/loop/check_tracks.h"

#include "database/model/rotation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace linkdig::host {

namespace {

/// A rectangle on the water.
struct Footprint {
    Vec2d middle{0};
    Vec2d half{0};
    double heading_rad = 0.0;
};

/// Half the shadow of a rectangle on an axis.
double reach(const Footprint& box, const Vec2d& axis) {
    const SineCosine h = sine_cosine(box.heading_rad);
    return box.half.x * std::fabs(axis.x * h.cosine + axis.y * h.sine) +
           box.half.y * std::fabs(axis.y * h.cosine - axis.x * h.sine);
}

/// Two rectangles overlap unless one of their four sides' directions separates them.
bool overlap(const Footprint& a, const Footprint& b) {
    for (const double heading :
         {a.heading_rad, a.heading_rad + pi / 2.0, b.heading_rad, b.heading_rad + pi / 2.0}) {
        const SineCosine h = sine_cosine(heading);
        const Vec2d axis(h.cosine, h.sine);
        if (std::fabs(glm::dot(b.middle - a.middle, axis)) > reach(a, axis) + reach(b, axis)) return false;
    }
    return true;
}

Footprint standing(const NameDirectory::Cluster& cluster) {
    return {Vec2d(cluster.middle_m), Vec2d(cluster.half_m), 0.0};
}

Footprint on_track(const NameDirectory::Cluster& ship, const Steering& steering) {
    const Vec3d middle = steering.position_m + steering.world_from_mean() * ship.middle_m;
    return {Vec2d(middle), Vec2d(ship.half_m), steering.heading_rad};
}

/// When the ship first meets the cluster; negative: never.
double meets_s(const NameDirectory::Cluster& ship, const NameDirectory::Cluster& pier, const ShipTrack& track,
               double duration_s) {
    const double breadth = std::max(1.0, std::min(ship.half_m.x, ship.half_m.y));
    const double step_s =
        track.speed_mps > 0.0 ? std::max(breadth / 2.0 / track.speed_mps, 0.01) : duration_s + 1.0;
    for (double time_s = 0.0;; time_s = std::min(time_s + step_s, duration_s)) {
        if (overlap(on_track(ship, track.at(time_s)), standing(pier))) return time_s;
        if (time_s >= duration_s || step_s > duration_s) return -1.0;
    }
}

} // namespace

void check_track(const ShipSection& ship, const ShipTrack& track, double duration_s,
                 const NameDirectory& directory, database::Diagnostics& diagnostics) {
    const auto row = directory.find_moving_object(ship.moving_object.text);
    const auto rides = [&](const NameDirectory::Cluster& each) {
        return row && each.moving_object == static_cast<std::int32_t>(*row);
    };
    const auto own = std::ranges::find_if(directory.clusters, rides);
    if (own == directory.clusters.end() || own->half_m.x <= 0.0) return;
    for (const NameDirectory::Cluster& pier : directory.clusters) {
        const bool unknown = pier.half_m.x <= 0.0 || pier.half_m.y <= 0.0;
        if (pier.moving_object != none || pier.priority != own->priority || unknown) continue;
        const double met_s = meets_s(*own, pier, track, duration_s);
        if (met_s >= 0.0)
            diagnostics.error(
                ship.moving_object.at,
                fmt::format("the track of \"{}\" leads through \"{}\" after {:.0f} s; expected a track clear "
                            "of what stands still",
                            ship.moving_object.text, pier.name, met_s));
    }
}

} // namespace linkdig::host
