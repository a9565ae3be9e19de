#include "host/scenario/sections.h"

#include "host/packet/check_packet.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <span>

namespace linkdig::host {

namespace {

/// Reports `name` if a section of the same kind has it already. `name_of`: a section's name.
template <typename Sections, typename NameOf>
void refuse_second(const Name& name, const Sections& before, NameOf name_of, const char* kind,
                   database::Diagnostics& diagnostics) {
    const auto same = std::ranges::find_if(
        before, [&](const Name& each) { return each.text == name.text; }, name_of);
    if (name.text.empty() || same == before.end()) return;
    diagnostics.error(name.at, fmt::format("a second {} for \"{}\"; the first stands in line {}", kind,
                                           name.text, std::invoke(name_of, *same).at.line));
}

constexpr Range elevation_range{-90.0, 90.0};
constexpr Range rate_range{-3600.0, 3600.0};

/// "sea_state": a preset of elevation and rate, which keys of their own override. None: nothing.
const SeaState* read_sea_state(TableReader& reader) {
    if (!reader.has("sea_state")) {
        reader.node("sea_state"); // known, though absent
        return nullptr;
    }
    std::vector<std::string> names;
    for (const SeaState& each : sea_states)
        names.emplace_back(each.name);
    return &sea_states[reader.choice("sea_state", 0, names)];
}

SunSection read_sun(TableReader& reader) {
    SunSection sun;
    const std::size_t mistakes = reader.diagnostics().all().size();
    sun.azimuth_rad = read_heading_rad(reader, "azimuth");
    const SeaState* state = read_sea_state(reader);
    std::optional<double> elevation_deg;
    if (state != nullptr) elevation_deg = state->elevation_deg;
    sun.has_sea_state = state != nullptr;
    sun.elevation_rad = reader.angle_rad("elevation", elevation_deg, elevation_range);
    // Keys per second, "azimuth_rate_deg_s": the host converts them to increments of its update rate.
    const double rate_deg_s = state != nullptr ? state->azimuth_rate_deg_s : 0.0;
    sun.azimuth_rate_rad_s = -radians(reader.number("azimuth_rate_deg_s", rate_deg_s, rate_range));
    sun.elevation_rate_rad_s = radians(reader.number("elevation_rate_deg_s", 0.0, rate_range));
    sun.least_elevation_rad = reader.angle_rad("least_elevation", 5.0, elevation_range);
    sun.greatest_elevation_rad =
        reader.angle_rad("greatest_elevation", state != nullptr ? 90.0 : 85.0, elevation_range);
    const bool read =
        reader.diagnostics().all().size() == mistakes; // else values stand in for those that are wrong
    if (read && sun.least_elevation_rad > sun.greatest_elevation_rad)
        reader.error_at("least_elevation_deg", "\"least_elevation_deg\" is above \"greatest_elevation_deg\"");
    else if (read && sun.turning() &&
             (sun.elevation_rad < sun.least_elevation_rad || sun.elevation_rad > sun.greatest_elevation_rad))
        reader.error_at("elevation_deg",
                        fmt::format("\"elevation_deg\" is {:.6g}; a turning sun stands between "
                                    "\"least_elevation_deg\" {:.6g} and \"greatest_elevation_deg\" {:.6g}",
                                    degrees(sun.elevation_rad), degrees(sun.least_elevation_rad),
                                    degrees(sun.greatest_elevation_rad)));
    reader.finish();
    return sun;
}

} // namespace

void read_suns(TableReader& root, Scenario& scenario) {
    const toml::table* suns = root.table("suns");
    if (suns == nullptr) return;
    for (auto&& [key, node] : *suns) {
        const std::string name(key.str());
        const database::SourceLocation at = database::location_of(node, root.file());
        if (node.as_table() == nullptr) {
            root.diagnostics().error(at, fmt::format("\"suns.{0}\" is no table; expected [suns.{0}]", name));
            continue;
        }
        TableReader reader(*node.as_table(), root.file(), fmt::format("[suns.{}]", name), root.diagnostics());
        SunSection sun = read_sun(reader);
        sun.sun = {name, at};
        scenario.suns.push_back(std::move(sun));
    }
}

void read_sequences(TableReader& root, Scenario& scenario) {
    for (const toml::table* table : root.tables("sequence")) {
        TableReader reader(*table, root.file(), "[[sequence]]", root.diagnostics());
        SequenceSection sequence;
        sequence.slot = read_name(reader, "slot");
        sequence.dwell_s = reader.duration_s("dwell", {}, {0.001, 3600.0});
        sequence.phase = reader.number("phase", 0.0, {0.0, 1.0});
        reader.finish();
        refuse_second(sequence.slot, scenario.sequences, &SequenceSection::slot, "[[sequence]]",
                      root.diagnostics());
        scenario.sequences.push_back(std::move(sequence));
    }
}

void read_approaches(TableReader& root, Scenario& scenario) {
    for (const toml::table* table : root.tables("approach")) {
        TableReader reader(*table, root.file(), "[[approach]]", root.diagnostics());
        ApproachSection approach;
        if (reader.has("ship")) approach.ship = read_name(reader, "ship");
        reader.node("ship"); // known, though absent
        approach.duration_s = reader.duration_s("duration", {}, {1.0, 86400.0});
        const std::size_t mistakes = reader.diagnostics().all().size();
        const std::vector<Vec3d> path = reader.points_m("path");
        const bool read = reader.diagnostics().all().size() == mistakes; // else points were left out
        if (path.size() == approach.path_m.size())
            std::ranges::copy(path, approach.path_m.begin());
        else if (read)
            reader.error_at(
                reader.has("path_m") ? "path_m" : "path_ft",
                fmt::format("the path has {} points; expected 4: start, two handles, hover", path.size()));
        approach.first_aim_m = reader.point_m("first_aim");
        approach.last_aim_m = reader.point_m("last_aim");
        reader.finish();
        scenario.approaches.push_back(std::move(approach));
    }
    if (scenario.approaches.empty() && !root.has("approach") &&
        scenario.own_ship.kind == OwnShipSection::Kind::approach)
        root.error_at(
            "approach",
            "the scenario has no [[approach]]; expected at least one, or [own_ship] of another kind");
    std::ranges::stable_sort(scenario.approaches, {}, &ApproachSection::duration_s);
}

void read_channels(TableReader& root, Scenario& scenario) {
    std::vector<Name> names;
    for (const toml::table* table : root.tables("channel")) {
        TableReader reader(*table, root.file(), "[[channel]]", root.diagnostics());
        ChannelSection channel;
        names.push_back(read_name(reader, "name"));
        channel.name = names.back().text;
        channel.horizontal_field_rad = reader.angle_rad("horizontal_field", {}, {1.0, 150.0});
        if (reader.has("vertical_field_deg"))
            channel.vertical_field_rad = reader.angle_rad("vertical_field", {}, {1.0, 150.0});
        else
            reader.node("vertical_field_deg"); // known, though absent
        channel.azimuth_rad = -reader.angle_rad("azimuth", 0.0, {-180.0, 180.0});
        channel.elevation_rad = reader.angle_rad("elevation", 0.0, elevation_range);
        reader.finish();
        refuse_second(names.back(), std::span(names).first(names.size() - 1), std::identity{}, "[[channel]]",
                      root.diagnostics());
        scenario.channels.push_back(std::move(channel));
    }
    const std::size_t count = scenario.channels.size();
    const bool left_out = count == 0 && !root.has("channel");
    if (left_out || count > max_channels)
        root.error_at("channel",
                      fmt::format("the scenario has {} channels; expected 1 to {}", count, max_channels));
}

void read_sea(TableReader& root, Scenario& scenario) {
    const toml::table* table = root.table("sea");
    if (table == nullptr) return;
    TableReader reader(*table, root.file(), "[sea]", root.diagnostics());
    scenario.sea_state = reader.number("state", 0.0, {0.0, 9.0});
    const std::vector<std::string> methods(sea_method_names.begin(), sea_method_names.end());
    scenario.sea_method = static_cast<SeaMethod>(reader.choice("method", 0, methods));
    scenario.sea_method_at = reader.at("method");
    scenario.normals_every = static_cast<std::uint32_t>(reader.integer("normals_every", 1, 1, 60));
    scenario.current_east_mps = reader.speed_mps("current_east", 0.0, {-10.0, 10.0});
    scenario.current_north_mps = reader.speed_mps("current_north", 0.0, {-10.0, 10.0});
    reader.finish();
}

void read_quays(TableReader& root, Scenario& scenario) {
    for (const toml::table* table : root.tables("quay")) {
        TableReader reader(*table, root.file(), "[[quay]]", root.diagnostics());
        const std::size_t mistakes = reader.diagnostics().all().size();
        const Quay quay{reader.point2_m("from"), reader.point2_m("to")};
        reader.finish();
        const Vec2d along = quay.to_m - quay.from_m;
        if (reader.diagnostics().all().size() == mistakes &&
            along.x * along.x + along.y * along.y < least_quay_m * least_quay_m)
            reader.error_at("to_m", "the quay has no length; expected two different places");
        scenario.quays.push_back(quay);
    }
    if (scenario.quays.size() > max_quays)
        root.error_at("quay", fmt::format("the scenario has {} quays; expected at most {}",
                                          scenario.quays.size(), max_quays));
}

void read_sky(TableReader& root, Scenario& scenario) {
    const toml::table* table = root.table("sky");
    if (table == nullptr) return;
    TableReader reader(*table, root.file(), "[sky]", root.diagnostics());
    const Vec3d rgb = reader.vector("rgb", Vec3d(scenario.sky) * 255.0);
    for (int i = 0; i < 3; ++i) {
        if (!(rgb[i] >= 0.0 && rgb[i] <= 255.0))
            reader.error_at("rgb", fmt::format("\"rgb\" has the component {}; expected 0 to 255", rgb[i]));
    }
    scenario.sky = Vec3f(rgb / 255.0);
    for (std::string& list : reader.texts("lists"))
        scenario.sky_lists.push_back({std::move(list), reader.at("lists")});
    scenario.visibility_m = reader.length_m("visibility", 0.0, {0.0, 1e6});
    scenario.time_of_day_h = reader.number("time_of_day_h", 12.0, {0.0, 24.0});
    scenario.hours_per_minute = reader.number("hours_per_minute", 0.0, {-1440.0, 1440.0});
    for (std::string& band : reader.texts("bands"))
        scenario.sky_bands.push_back({std::move(band), reader.at("bands")});
    scenario.lamps_by_day = reader.number("lamps_by_day", 0.3, {0.0, 1.0});
    reader.finish();
}

void read_ships(TableReader& root, Scenario& scenario) {
    for (const toml::table* table : root.tables("ship")) {
        TableReader reader(*table, root.file(), "[[ship]]", root.diagnostics());
        ShipSection ship = read_ship(reader);
        refuse_second(ship.moving_object, scenario.ships, &ShipSection::moving_object, "[[ship]]",
                      root.diagnostics());
        scenario.ships.push_back(std::move(ship));
    }
}

} // namespace linkdig::host
