#pragma once
/// Output of geometry: faces on the channel's raster, in rank order, snapped to fixed point.
///
/// Formats (bounds in docs/conventions-and-limits.md):
///   coordinate  1/256 pixel, |c| <= 32767 px (inside the guard band): 23 bits and sign; a crossing half a
///   pixel
///               beyond must stay below 2^15 px, or it wraps (ig/edges/edge.h)
///   intensity   1.0 = 2^22, 0 to 1.0

#include "database/model/vectors.h"
#include "ig/active/light_steps.h"

#include <array>
#include <cstdint>
#include <vector>

namespace linkdig::ig {

inline constexpr std::int32_t subpixels = 256;
inline constexpr std::int32_t guard_pixels = 32768;
inline constexpr std::int32_t intensity_one = 1 << 22;
/// Opacity of a face that lets nothing through.
inline constexpr std::uint16_t opaque = 256;

/// A snapped vertex: where along the lines' axis, where along the elements' axis, in 1/256 pixel. Pixel
/// (line, element) has its centre at (line + 1/2, element + 1/2).
struct RasterPoint {
    std::int32_t line = 0;
    std::int32_t element = 0;
    bool operator==(const RasterPoint&) const = default;
};

/// First line whose centre is at or below `coordinate` (1/256 pixel).
inline std::int32_t first_line_at(std::int32_t coordinate) { return (coordinate + 127) >> 8; }

/// The corners that define a face's intensity on the screen: the triangle before clipping. Doubles hold
/// snapped values where the corner lies in the guard band, unsnapped ones (at most 1e12 px) where it does
/// not.
struct IntensityTriangle {
    double line[3] = {0, 0, 0};    ///< 1/256 pixel
    double element[3] = {0, 0, 0}; ///< 1/256 pixel
    std::int32_t intensity[3] = {0, 0, 0};
};

/// Where a face's plane lies, as seen: 1/z is linear on the screen, z along the line of sight, metres. Taken from the
/// unsnapped face before any clipping; shared by the pieces that the face is cut into.
struct DepthPlane {
    double inverse_m = 0; ///< 1/z at the centre of pixel (line 0, element 0)
    double across = 0;    ///< per line
    double along = 0;     ///< per element
    double nearest_m = 0; ///< bounds of the range (Euclidean) over the face; farthest may be infinite
    double farthest_m = 0;
};

/// One convex polygon on the raster. Corners run so that its signed area is positive in (element, line)
/// coordinates with line down.
struct ProjectedFace {
    std::uint32_t first_point = 0; ///< into ProjectedFaces::points
    std::uint16_t point_count = 0;
    std::uint16_t colour = 0;
    std::int32_t triangle = -1;             ///< into ProjectedFaces::triangles, or -1: flat
    std::int32_t intensity = intensity_one; ///< of a flat face
    std::uint32_t block = 0;                ///< into ActiveDatabase::blocks
    std::uint32_t face = 0;                 ///< into that block's faces
    std::int32_t depth = -1;                ///< into ProjectedFaces::depths, or -1: range plays no part
    std::uint32_t list = 0;                 ///< into VisualDatabase::lists
    std::int32_t added_to = -1; ///< additive face: the list whose faces it brightens; -1: an ordinary one
    std::uint16_t opacity = opaque;
    /// Coloured face: its triangle, and those this many and twice as many further, are of red, green and blue, 255 being
    /// 1.0. 0: one intensity for the colour code.
    std::uint32_t colour_step = 0;
    std::uint16_t fade = opaque; ///< what is seen of its level of detail, of 256: beside its own opacity
    std::int32_t level = -1;     ///< into VisualDatabase::detail_levels while that fades, else -1
};

/// A light point on the raster.
struct ProjectedLight {
    RasterPoint at;
    std::int32_t radius = 0;  ///< of its splat, 1/256 pixel
    std::uint32_t total = 0;  ///< light of the whole splat: 1/256 of a pixel at the full colour code
    std::uint32_t rank = 0;   ///< of the first face that it stands before: it is behind all of a lower rank
    std::uint16_t colour = 0; ///< of the database's table
};

/// From tangents to the raster: picture column in 1/256 pixel = x_scale * x/z + x_offset, row likewise, down.
struct PictureScale {
    double x_scale = 1, x_offset = 0;
    double y_scale = 1, y_offset = 0;
    bool operator==(const PictureScale&) const = default;
};

struct ProjectedFaces {
    PictureScale scale;
    std::vector<ProjectedFace> faces; ///< ascending rank: the index is the rank on this channel
    std::vector<RasterPoint> points;
    std::vector<IntensityTriangle> triangles;
    std::vector<DepthPlane> depths;
    std::vector<ProjectedLight> lights; ///< ascending by rank
    std::uint64_t offered = 0;          ///< faces looked at
    std::uint64_t lights_offered = 0;   ///< light points of those runs
    std::uint64_t lights_left_out = 0;  ///< of them, by the light step
    /// Light points that shine into the picture and that each light step lets through; true from the step before the
    /// present one on, and nothing before that.
    std::array<std::uint64_t, light_steps + 1> lights_at_step{};
};

} // namespace linkdig::ig
