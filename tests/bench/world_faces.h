#pragma once
/// The faces of a frame as any renderer would be given them: world space, back to front, shared vertices.

#include "host/packet/frame_packet.h"
#include "tools/bench/scene.h"

#include <cstdint>
#include <vector>

namespace linkdig::bench {

struct WorldVertex {
    float position[4];      ///< metres from the frame's eye; w = 0 is a direction
    float normal[3];        ///< world
    std::uint8_t colour[4]; ///< colour code
    float light[3];         ///< ambient, diffuse, row of the packet's suns; a row of -1: intensity 1
};

struct WorldFaces {
    Vec3d eye_m{0}; ///< what positions are measured from
    std::vector<WorldVertex> vertices;
    std::vector<std::uint32_t> indices; ///< three per triangle, in painter's order
};

/// The faces of a channel of a packet. Smooth-shaded faces of a list share their vertices.
WorldFaces world_faces(const VisualDatabase& database, const FramePacket& packet, std::size_t channel);

} // namespace linkdig::bench
