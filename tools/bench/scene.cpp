#include "tools/bench/scene.h"

#include "tools/flight/flight.h"
#include "tools/flight/shipped_scenes.h"

#include <algorithm>
#include <stdexcept>

namespace linkdig::bench {

namespace {

/// A shipped scenario as a scene: the packets of its first ten seconds, recorded from the host's loop.
Scene shipped_scene(const std::string& name, const std::string& scenario, bool vertical_scan) {
    tools::FlightRequest request;
    request.scenario_path = tools::shipped_scenes() + "/" + scenario;
    request.configuration = vertical_scan ? ig::ames_profile() : ig::modern_profile();
    request.configuration.raster.width = 16; // the packets alone are wanted
    request.configuration.raster.height = vertical_scan ? 12 : 16;
    request.configuration.update_rate_hz = 30.0;
    tools::Flight flight(request);
    std::vector<FramePacket> packets;
    for (std::uint64_t frame = 0; frame < 300; ++frame) {
        flight.draw(frame, {});
        packets.push_back(flight.packet());
        packets.back().database_id = 0;
    }
    Scene scene;
    scene.name = name;
    scene.database = flight.database();
    scene.vertical_scan = vertical_scan;
    scene.packet = [packets = std::move(packets)](std::uint64_t frame) {
        return packets[frame % packets.size()];
    };
    return scene;
}

} // namespace

const std::vector<std::string>& scene_names() {
    static const std::vector<std::string> names{"sea", "airfield", "dense", "approach", "ames"};
    return names;
}

Scene make_scene(const std::string& name) {
    if (name == "sea") return sea_scene();
    if (name == "airfield") return airfield_scene();
    if (name == "dense") return dense_scene();
    if (name == "approach") return shipped_scene(name, "first_flight/approach.toml", false);
    if (name == "ames") return shipped_scene(name, "first_flight/four_windows.toml", true);
    throw std::invalid_argument("there is no scene '" + name +
                                "'; expected sea, airfield, dense, approach or ames");
}

} // namespace linkdig::bench
