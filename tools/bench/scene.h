#pragma once
/// Scenes for measuring: visual databases made in code, or shipped ones, with the packets that fly them.

#include "database/model/visual_database.h"
#include "host/packet/frame_packet.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace linkdig::bench {

struct Scene {
    std::string name;
    VisualDatabase database;
    /// The packet of a frame: the eye drifts and the suns turn, so that nothing stays as it was.
    std::function<FramePacket(std::uint64_t)> packet;
    bool vertical_scan = false;
};

/// "sea", "airfield", "dense", "approach", "ames": see scene_names().
const std::vector<std::string>& scene_names();

/// Throws std::invalid_argument if there is no such scene, std::runtime_error if a shipped database cannot be read.
Scene make_scene(const std::string& name);

/// 64 x 64 smooth-shaded squares of 300 m, out to the horizon of an eye 30 m above the water (19.2 km; a round earth's lies
/// at 19.5 km), a ship of 1,500 faces 250 m ahead, and a sky of 24 faces.
Scene sea_scene();

/// 2,000 polygons, face-shaded: grass, runway, taxiways and ramps as large ground faces, markings on them, buildings.
Scene airfield_scene();

/// `triangles` smooth-shaded triangles scattered over the picture in three layers: depth complexity 3 at any number.
Scene dense_scene(std::uint32_t triangles = 20000);

} // namespace linkdig::bench
