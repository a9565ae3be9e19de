#include "tests/support/unsnapped_painter.h"

#include <algorithm>
#include <cmath>

namespace linkdig::support {
namespace {

using Real = long double;
struct Vector {
    Real x = 0, y = 0, z = 0;
};
Vector cross(const Vector& a, const Vector& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
Real dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

Vector vector_of(const Vec3d& v) { return {v.x, v.y, v.z}; }

/// The cone from the eye through a face: a ray d = (x, y, 1) meets the face if dot(side, d) has one sign for all sides
/// (the edge functions of Olano and Greer, Triangle Scan Conversion using 2D Homogeneous Coordinates, 1997: no clipping).
struct Cone {
    std::int64_t block = 0;
    std::int64_t face = 0;
    bool two_sided = false;
    bool endless = true; ///< all corners at infinity
    std::vector<Vector> sides;
    Vector normal;
    Real distance = 0; ///< dot(normal, p) of the face's points
};

class Reader {
public:
    Reader(const ig::ActiveDatabase& active, const ChannelView& channel)
        : active_(active), eye_m_(channel.eye_m) {
        const Mat3d body = world_from_body(channel.attitude);
        axes_[0] = vector_of(-body[1]);
        axes_[1] = vector_of(body[2]);
        axes_[2] = vector_of(body[0]);
    }

    Cone cone(std::uint32_t block_index, std::uint32_t face_index) const {
        const ig::FaceBlock& block = active_.blocks[block_index];
        const Face& face = block.faces[face_index];
        Cone cone{.block = block_index,
                  .face = face_index,
                  .two_sided = face.two_sided != 0,
                  .sides = {},
                  .normal = {}};
        std::vector<Vector> corners;
        std::vector<bool> finite;
        for (std::uint32_t k = 0; k < face.corner_count; ++k) {
            const Vec4f& p = block.vertices[block.corners[face.first_corner + k]].position;
            finite.push_back(p.w != 0.0F);
            corners.push_back(in_channel(block, p));
        }
        find_plane(corners, finite, cone);
        for (std::size_t i = 0; i < corners.size(); ++i)
            cone.sides.push_back(cross(corners[i], corners[(i + 1) % corners.size()]));
        return cone;
    }

private:
    Vector in_channel(const ig::FaceBlock& block, const Vec4f& p) const {
        Vec3d world = block.world_from_list * Vec3d(p);
        if (p.w != 0.0F && !block.at_eye) world += block.origin_m - eye_m_;
        const Vector v = vector_of(world);
        return {dot(axes_[0], v), dot(axes_[1], v), dot(axes_[2], v)};
    }

    /// By Newell's sum about a finite corner; a corner at infinity is its direction.
    static void find_plane(const std::vector<Vector>& corners, const std::vector<bool>& finite, Cone& cone) {
        const auto base = std::find(finite.begin(), finite.end(), true);
        cone.endless = base == finite.end();
        if (cone.endless) return;
        const Vector origin = corners[static_cast<std::size_t>(base - finite.begin())];
        const auto from_origin = [&](std::size_t i) {
            const Vector& c = corners[i];
            return finite[i] ? Vector{c.x - origin.x, c.y - origin.y, c.z - origin.z} : c;
        };
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const Vector n = cross(from_origin(i), from_origin((i + 1) % corners.size()));
            cone.normal = {cone.normal.x + n.x, cone.normal.y + n.y, cone.normal.z + n.z};
        }
        cone.distance = dot(cone.normal, origin);
    }

    const ig::ActiveDatabase& active_;
    Vec3d eye_m_;
    Vector axes_[3];
};

/// Does the ray meet the face, and how far inside its border, pixels; negative outside.
class PixelRay {
public:
    PixelRay(Real x, Real y, Real x_per_pixel, Real y_per_pixel)
        : ray_{x, y, 1}, x_per_pixel_(x_per_pixel), y_per_pixel_(y_per_pixel) {}

    Real inside(const Cone& cone) const {
        // The channel's frame is left-handed (x right, y up, z ahead): a front has the eye behind its Newell normal.
        Real facing = 1; // a face at infinity is seen from its front
        if (!cone.endless) {
            facing = cone.distance;
            const Real cosine = dot(cone.normal, ray_);
            if (cosine == 0 || facing / cosine < static_cast<Real>(ig::near_plane_m)) return outside;
        }
        if (!cone.two_sided && facing <= 0) return outside;
        const Real sign = facing < 0 ? -1 : 1;
        Real least = 1e9L;
        for (const Vector& side : cone.sides) {
            const Real slope = std::hypot(side.x * x_per_pixel_, side.y * y_per_pixel_);
            if (slope > 0) least = std::min(least, sign * dot(side, ray_) / slope);
        }
        return least;
    }

private:
    static constexpr Real outside = -1e9L;
    Vector ray_;
    Real x_per_pixel_;
    Real y_per_pixel_;
};

} // namespace

std::vector<SeenFace> paint_unsnapped(const ig::ActiveDatabase& active, const ig::PriorityOrder& order,
                                      const ChannelView& channel, const ig::Raster& raster, double margin) {
    const Reader reader(active, channel);
    std::vector<Cone> cones;
    for (const ig::RankedRun& ranked : order.runs) {
        const FaceRun& run = active.blocks[ranked.block].runs[ranked.run];
        for (std::uint32_t f = run.first_face; f < run.first_face + run.face_count; ++f)
            cones.push_back(reader.cone(ranked.block, f));
    }
    const Real across = (static_cast<Real>(channel.right_tangent) - channel.left_tangent) / raster.width;
    const Real down = (static_cast<Real>(channel.top_tangent) - channel.bottom_tangent) / raster.height;
    std::vector<SeenFace> picture;
    for (std::uint32_t row = 0; row < raster.height; ++row)
        for (std::uint32_t column = 0; column < raster.width; ++column) {
            const PixelRay ray(channel.left_tangent + across * (column + 0.5L),
                               channel.top_tangent - down * (row + 0.5L), across, down);
            SeenFace seen;
            for (const Cone& cone : cones) {
                const Real inside = ray.inside(cone);
                if (std::fabs(inside) < margin) seen.near_an_edge = true;
                if (inside < 0) continue;
                seen.block = cone.block;
                seen.face = cone.face;
                break;
            }
            picture.push_back(seen);
        }
    return picture;
}

} // namespace linkdig::support
