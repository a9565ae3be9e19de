#include "host/scenario/sections.h"

#include <fmt/format.h>

#include <algorithm>

namespace linkdig::host {

namespace {

using Kind = TrackSection::Kind;

/// "port" or "starboard".
bool read_side(TableReader& reader) { return reader.choice("to", 1, {"port", "starboard"}) == 0; }

} // namespace

TrackSection read_track(TableReader& reader) {
    TrackSection track;
    track.kind =
        static_cast<Kind>(reader.choice("kind", 0, {"straight", "turn", "figure_of_eight", "station"}));
    if (track.kind == Kind::turn || track.kind == Kind::figure_of_eight) {
        track.begin_s = reader.duration_s("begin", 0.0, {0.0, 86400.0});
        track.radius_m = reader.length_m("radius", {}, {10.0, 100000.0});
        track.to_port = read_side(reader);
    }
    if (track.kind == Kind::turn) track.angle_rad = reader.angle_rad("angle", 0.0, {0.0, 3600.0});
    if (track.kind == Kind::station) {
        track.leader = read_name(reader, "leader");
        track.offset_m = reader.point_m("offset");
        if (track.offset_m.z != 0.0)
            reader.error_at("offset_m", "a station lies on the water; expected an offset of height 0");
    }
    reader.finish();
    return track;
}

void check_stations(const Scenario& scenario, database::Diagnostics& diagnostics) {
    for (const ShipSection& ship : scenario.ships) {
        const Name& leader = ship.track.leader;
        if (ship.track.kind != Kind::station || leader.text.empty()) continue;
        const auto found = std::ranges::find_if(
            scenario.ships, [&](const ShipSection& each) { return each.moving_object.text == leader.text; });
        if (found != scenario.ships.end() && found->track.kind == Kind::station)
            diagnostics.error(
                leader.at,
                fmt::format("\"{}\" keeps station herself; expected a ship with a track of her own",
                            leader.text));
    }
}

} // namespace linkdig::host
