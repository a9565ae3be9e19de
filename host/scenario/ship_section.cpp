#include "host/scenario/sections.h"
#include "host/scenario/time_history.h"

#include <fmt/format.h>

#include <limits>

namespace linkdig::host {

namespace {

constexpr Range gain_range{0.0, 100.0};
constexpr Range limit_m_range{0.0, 10.0};
constexpr Range limit_deg_range{0.0, 30.0};

/// Greatest roll and pitch, degrees: what stands in the report's 3.3.1, and in 3.3.2 for landing and for the demonstration.
struct LimitsPreset {
    double roll_deg;
    double pitch_deg;
};
constexpr LimitsPreset preset_limits[] = {{8.0, 5.0}, {6.8, 5.0}, {6.8, 10.0}};
constexpr Range natural_range_s{1.0, 60.0};

/// A linear axis: AXIS_gain, AXIS_limit_m.
AxisSection read_shift(TableReader& reader, const std::string& axis, double gain, double limit_m) {
    return {reader.number(axis + "_gain", gain, gain_range),
            reader.length_m(axis + "_limit", limit_m, limit_m_range)};
}

/// An angular axis: AXIS_gain, AXIS_limit_deg.
AxisSection read_turn(TableReader& reader, const std::string& axis, double gain, double limit_deg) {
    return {reader.number(axis + "_gain", gain, gain_range),
            reader.angle_rad(axis + "_limit", limit_deg, limit_deg_range)};
}

std::vector<HistoryRow> read_motion_file(TableReader& reader) {
    const std::string path = reader.beside(reader.text("file"));
    return read_history(path, ship_history_columns(), reader.at("file"), reader.diagnostics());
}

/// Defaults: estimated, for a ship of LPH-2's size; limits of roll and pitch from the report, 3.3.1.
MotionSection read_motion(TableReader& reader) {
    MotionSection motion;
    if (reader.has("file")) {
        motion.history = read_motion_file(reader);
        reader.finish();
        return motion;
    }
    reader.node("file"); // known, though absent
    const LimitsPreset limits =
        preset_limits[reader.choice("limits", 0, {"approach", "landing", "demonstration"})];
    motion.significant_height_m = reader.length_m("significant_height", {}, {0.0, 20.0});
    motion.period_s = reader.duration_s("period", {}, {2.0, 30.0});
    motion.travel_heading_rad = read_heading_rad(reader, "seas_from") + pi;
    motion.seed =
        static_cast<std::uint64_t>(reader.integer("seed", 0, 0, std::numeric_limits<std::int64_t>::max()));
    motion.components = static_cast<std::uint32_t>(reader.integer("components", 12, 1, 64));
    motion.length_m = reader.length_m("length", 180.0, {1.0, 500.0});
    motion.heave_period_s = reader.duration_s("heave_period", 8.0, natural_range_s);
    motion.roll_period_s = reader.duration_s("roll_period", 14.0, natural_range_s);
    motion.pitch_period_s = reader.duration_s("pitch_period", 7.5, natural_range_s);
    motion.axes = {read_shift(reader, "surge", 0.5, 2.0),
                   read_shift(reader, "sway", 0.5, 2.0),
                   read_shift(reader, "heave", 1.0, 3.0),
                   read_turn(reader, "roll", 1.0, limits.roll_deg),
                   read_turn(reader, "pitch", 1.0, limits.pitch_deg),
                   read_turn(reader, "yaw", 0.3, 2.0)};
    reader.finish();
    return motion;
}

} // namespace

ShipSection read_ship(TableReader& reader) {
    ShipSection ship;
    ship.moving_object = read_name(reader, "moving_object");
    ship.position_m = reader.point_m("position", Vec3d(0.0));
    if (const toml::table* table = reader.table("track")) {
        TableReader track(*table, reader.file(), "[ship.track]", reader.diagnostics());
        ship.track = read_track(track);
    }
    if (ship.track.kind != TrackSection::Kind::station) { // which has both from her leader
        ship.heading_rad = read_heading_rad(reader, "heading");
        ship.speed_mps = reader.speed_mps("speed", {}, {0.0, 30.0});
    }
    ship.methods = read_methods(reader);
    if (const toml::table* table = reader.table("motion")) {
        TableReader motion(*table, reader.file(), "[ship.motion]", reader.diagnostics());
        ship.motion = read_motion(motion);
    }
    reader.finish();
    return ship;
}

} // namespace linkdig::host
