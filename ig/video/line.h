#pragma once
/// Output of video: the channel's picture and, on demand, planes that explain it.

#include <cstdint>
#include <vector>

namespace linkdig::ig {

/// What else a frame can be dumped as.
/// `edges`: the picture under the borders of what is seen; `flat`: each face in one colour, by its own normal, without air.
enum class Plane : std::uint8_t { colour, intensity, face, object, list, rank, edges, flat };

/// One channel's picture as the viewer sees it: row by row from the top, left to right, whatever the scan.
struct VideoFrame {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::vector<std::uint32_t> pixels; ///< 0xAABBGGRR in memory order R, G, B, A = 255
    /// Optional planes, empty unless asked for. `none` (-1) where only the background is seen.
    std::vector<std::int32_t> intensity; ///< 1.0 = 2^22
    std::vector<std::int32_t> rank;      ///< into ProjectedFaces::faces
};

} // namespace linkdig::ig
