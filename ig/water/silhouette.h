#pragma once
/// What a hull does to the water, seen from above on a small square of pixels: steps 1 and 2 of the silhouette pyramid (Yuksel).

#include "database/model/vectors.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace linkdig::ig {

/// A triangle of a closed hull in body axes, counter-clockwise seen from outside, metres.
using HullTriangle = std::array<Vec3d, 3>;

/// How the hull floats and moves. The water's surface at rest is z = 0 of the world.
struct HullMotion {
    Mat3d world_from_body{1.0}; ///< heading, pitch and roll
    Vec3d position{0.0};        ///< of the body's origin, metres; z is heave
    Vec3d velocity_mps{0.0};    ///< of the body's origin
    Vec3d turn_rate_rad_s{0.0}; ///< angular velocity, world axes
};

/// Pixels in rows that run to +y. A pixel's wave effects are the water that faces push out of their way there, m^3/s, negative
/// where they make room.
struct Silhouette {
    std::uint32_t size = 0;              ///< pixels a side, a power of two from 4 to 64
    double pixel = 1.0;                  ///< side of a pixel, metres
    Vec2d origin{0.0};                   ///< the corner of least x and y
    std::vector<std::uint8_t> filled;    ///< there is hull in the water
    std::vector<std::uint8_t> submerged; ///< its top is in the water, too
    std::vector<double> depth;           ///< of its highest face in the water, metres below the surface
    std::vector<double> direct;          ///< effect of faces that the water lies on
    std::vector<double> indirect;        ///< effect of the others: it comes up at the hull's outline

    std::size_t at(std::uint32_t column, std::uint32_t row) const { return std::size_t{row} * size + column; }
};

/// An empty one. Sizes other than 4, 8, 16, 32, 64 become the next of these.
Silhouette empty_silhouette(std::uint32_t size, double pixel, const Vec2d& origin);

/// The part of the hull below the surface, as it floats, on a square that fits it with a pixel to spare all around.
Silhouette draw_silhouette(std::span<const HullTriangle> hull, const HullMotion& motion, std::uint32_t size);

/// Memory that drawing takes; kept, the next drawing asks for none.
struct SilhouetteScratch {
    std::vector<HullTriangle> wet;
    std::vector<double> normal_z;
    std::vector<std::uint8_t> rim;
};

/// The same, into a silhouette that is there.
void draw_silhouette(std::span<const HullTriangle> hull, const HullMotion& motion, std::uint32_t size,
                     SilhouetteScratch& scratch, Silhouette& silhouette);

} // namespace linkdig::ig
