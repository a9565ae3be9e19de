#include "host/scenario/sections.h"

#include <fmt/format.h>

#include <limits>

namespace linkdig::host {

namespace {

constexpr Range gain_range{0.0, 100.0};
constexpr Range limit_m_range{0.0, 10.0};
constexpr Range limit_deg_range{0.0, 30.0};
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

/// Defaults: estimated, for a ship of LPH-2's size; limits of roll and pitch from the report, 3.3.1.
MotionSection read_motion(TableReader& reader) {
    MotionSection motion;
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
    motion.axes = {read_shift(reader, "surge", 0.5, 2.0), read_shift(reader, "sway", 0.5, 2.0),
                   read_shift(reader, "heave", 1.0, 3.0), read_turn(reader, "roll", 1.0, 8.0),
                   read_turn(reader, "pitch", 1.0, 5.0),  read_turn(reader, "yaw", 0.3, 2.0)};
    reader.finish();
    return motion;
}

} // namespace

ShipSection read_ship(TableReader& reader) {
    ShipSection ship;
    ship.moving_object = read_name(reader, "moving_object");
    ship.position_m = reader.point_m("position", Vec3d(0.0));
    ship.heading_rad = read_heading_rad(reader, "heading");
    ship.speed_mps = reader.speed_mps("speed", {}, {0.0, 30.0});
    if (const toml::table* table = reader.table("motion")) {
        TableReader motion(*table, reader.file(), "[ship.motion]", reader.diagnostics());
        ship.motion = read_motion(motion);
    }
    reader.finish();
    return ship;
}

} // namespace linkdig::host
