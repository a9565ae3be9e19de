#include "host/scenario/sections.h"

#include "host/packet/check_packet.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace linkdig::host {

namespace {

/// One name, or an array of them: "none" alone stands for no wake.
Wakes read_wakes(TableReader& ship) {
    std::vector<std::string> names;
    const toml::node* node = ship.node("wake");
    if (node != nullptr && node->is_string())
        names.push_back(ship.text("wake"));
    else
        names = ship.texts("wake");
    if (node != nullptr && node->is_array() && node->as_array()->empty())
        ship.error_at("wake", fmt::format("\"wake\" names nothing; expected \"none\", or some of {}",
                                          fmt::join(wake_names, ", ")));
    Wakes wakes{};
    for (const std::string& name : names) {
        const auto found = std::ranges::find(wake_names, name);
        if (found != wake_names.end())
            wakes[static_cast<std::size_t>(found - wake_names.begin())] = true;
        else if (name != "none" || names.size() > 1)
            ship.error_at("wake", fmt::format("\"wake\" names \"{}\"; expected \"none\", or some of {}", name,
                                              fmt::join(wake_names, ", ")));
    }
    return wakes;
}

std::uint32_t read_faces(TableReader& reader, const char* key, std::uint32_t faces) {
    return static_cast<std::uint32_t>(
        reader.integer(key, faces, 256, static_cast<std::int64_t>(most_wake_faces)));
}

WaterSection read_water(TableReader& reader) {
    WaterSection water;
    water.kelvin_faces = read_faces(reader, "kelvin_faces", water.kelvin_faces);
    water.kelvin_age_s = reader.duration_s("kelvin_age", water.kelvin_age_s, {5.0, most_wake_age_s});
    water.particle_faces = read_faces(reader, "particle_faces", water.particle_faces);
    water.strength = reader.number("strength", water.strength, {0.0, 10.0});
    water.heights = reader.boolean("heights", water.heights);
    water.length_m = reader.length_m("length", water.length_m, {1.0, 1000.0});
    water.beam_m = reader.length_m("beam", water.beam_m, {0.1, 1000.0});
    reader.finish();
    return water;
}

} // namespace

MethodsSection read_methods(TableReader& ship) {
    MethodsSection methods;
    if (ship.has("occulting")) {
        const std::vector<std::string> names(occulting_names.begin(), occulting_names.end());
        methods.occulting = static_cast<Occulting>(ship.choice("occulting", 0, names));
    } else {
        ship.node("occulting"); // known, though absent
    }
    methods.occulting_at = ship.at("occulting");
    if (ship.has("wake"))
        methods.wakes = read_wakes(ship);
    else
        ship.node("wake");
    methods.wake_at = ship.at("wake");
    methods.lights = static_cast<ShipLights>(
        ship.choice("lights", 0, {ship_lights_names.begin(), ship_lights_names.end()}));
    methods.lights_at = ship.at("lights");
    methods.wake_dwell_s = ship.duration_s("wake_dwell", methods.wake_dwell_s, {0.001, 3600.0});
    if (const toml::table* table = ship.table("cam")) {
        TableReader cam(*table, ship.file(), "[ship.cam]", ship.diagnostics());
        methods.cam_position_m = cam.point_m("position", methods.cam_position_m);
        methods.cam_axis_rad = cam.angle_rad("axis", degrees(methods.cam_axis_rad), {-90.0, 90.0});
        methods.cam_period_s = cam.duration_s("period", methods.cam_period_s, {0.1, 60.0});
        cam.finish();
    }
    if (const toml::table* table = ship.table("water")) {
        TableReader water(*table, ship.file(), "[ship.water]", ship.diagnostics());
        methods.water = read_water(water);
    }
    return methods;
}

} // namespace linkdig::host
