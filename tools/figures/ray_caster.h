#pragma once
/// A ray caster with a ship that is modelled whole and a sea that is an opaque
/// plane: what the occulting methods should show. Exact ray and triangle, no
/// order, nothing in common with the machine.

#include "database/model/visual_database.h"
#include "host/packet/frame_packet.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace linkdig::tools {

enum class Hit : std::uint8_t { sky, sea, ship };

enum class ShipPart : std::uint8_t { whole, below_waterline };

/// Triangles of what is rigid in a ship's cluster, in her body frame:
/// everything without a slot, and her hull below the waterline; or the latter alone.
struct ShipTriangles {
    std::vector<std::array<Vec3d, 3>> triangles;
};
ShipTriangles ship_triangles(const VisualDatabase& database, const std::string& ship,
                             ShipPart part = ShipPart::whole);

/// The nearest hit of the ray through each pixel's centre of channel 0, row by
/// row.
std::vector<Hit> cast(const ShipTriangles& ship, const MovingObject& pose, const ChannelView& channel,
                      std::uint32_t width, std::uint32_t height);

} // namespace linkdig::tools
