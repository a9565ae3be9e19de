#include "host/scenario/sections.h"

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
    return methods;
}

} // namespace linkdig::host
