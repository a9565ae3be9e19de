#include "ig/water/silhouette.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace linkdig::ig {

namespace {

/// A sign smaller than this is that of an upright face, which has none.
constexpr double upright = 1e-9;

/// What lies below the surface: none, one or two triangles.
void cut_at_surface(const HullTriangle& triangle, std::vector<HullTriangle>& wet) {
    std::array<Vec3d, 4> kept{};
    std::size_t count = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec3d& a = triangle[k];
        const Vec3d& b = triangle[(k + 1) % 3];
        if (a.z <= 0.0) kept[count++] = a;
        if ((a.z <= 0.0) != (b.z <= 0.0)) {
            Vec3d crossing = a + (b - a) * (a.z / (a.z - b.z));
            crossing.z = 0.0;
            kept[count++] = crossing;
        }
    }
    for (std::size_t k = 2; k < count; ++k)
        wet.push_back({kept[0], kept[k - 1], kept[k]});
}

/// Halves the longest side until none is longer than `most`; at most `depth` times.
template <typename Each>
void for_each_small(const HullTriangle& triangle, double most, int depth, Each each) {
    std::size_t longest = 0;
    double length = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
        const double side = glm::length(triangle[(k + 1) % 3] - triangle[k]);
        if (side > length) {
            length = side;
            longest = k;
        }
    }
    if (length <= most || depth == 0) {
        each(triangle);
        return;
    }
    const Vec3d& a = triangle[longest];
    const Vec3d& b = triangle[(longest + 1) % 3];
    const Vec3d& c = triangle[(longest + 2) % 3];
    const Vec3d middle = 0.5 * (a + b);
    for_each_small({a, middle, c}, most, depth - 1, each);
    for_each_small({middle, b, c}, most, depth - 1, each);
}

class Drawing {
public:
    Drawing(Silhouette& target, SilhouetteScratch& scratch)
        : target_(target), normal_z_(scratch.normal_z), rim_(scratch.rim) {
        normal_z_.assign(target.filled.size(), 0.0);
        rim_.assign(target.filled.size(), 0);
    }

    /// Step 1: the highest point in the water over each pixel's middle.
    void fill(const HullTriangle& t) {
        const Vec3d normal = glm::cross(t[1] - t[0], t[2] - t[0]);
        const double length = glm::length(normal);
        if (!(length > 0.0) || std::fabs(normal.z) <= upright * length) return;
        const auto [left, right] = std::minmax({t[0].x, t[1].x, t[2].x});
        const auto [low, high] = std::minmax({t[0].y, t[1].y, t[2].y});
        for (std::uint32_t row = pixel_of(low, target_.origin.y); row <= pixel_of(high, target_.origin.y);
             ++row)
            for (std::uint32_t column = pixel_of(left, target_.origin.x);
                 column <= pixel_of(right, target_.origin.x); ++column) {
                const Vec2d middle = target_.origin + target_.pixel * Vec2d(static_cast<double>(column) + 0.5,
                                                                            static_cast<double>(row) + 0.5);
                if (!inside(t, normal.z, middle)) continue;
                const double z =
                    t[0].z - (normal.x * (middle.x - t[0].x) + normal.y * (middle.y - t[0].y)) / normal.z;
                put(target_.at(column, row), -z, normal.z / length);
            }
    }

    /// A pixel that has faces, though none over its middle: thin hulls and bows do not vanish.
    void fill_point(const Vec3d& point, double normal_z) {
        const std::size_t at = pixel_at(point);
        if (target_.filled[at] == 0 || rim_[at] != 0) {
            rim_[at] = 1;
            put(at, -point.z, normal_z);
        }
    }

    /// Upright faces alone do not say whether there is water above: the neighbours do.
    void settle() {
        for (std::uint32_t row = 0; row < target_.size; ++row)
            for (std::uint32_t column = 0; column < target_.size; ++column) {
                const std::size_t at = target_.at(column, row);
                double normal_z = normal_z_[at];
                if (rim_[at] != 0 && std::fabs(normal_z) <= upright) normal_z = of_neighbours(column, row);
                target_.submerged[at] = target_.filled[at] != 0 && normal_z > upright ? 1 : 0;
            }
    }

    /// Step 2: a face's effect (its area as a vector), direct where the water lies on it.
    void add_effect(const Vec3d& point, const Vec3d& area, double effect) {
        const std::size_t at = pixel_at(point);
        bool on_top = target_.submerged[at] != 0 && area.z > upright * glm::length(area);
        if (on_top) {
            // A face that is the highest itself differs from the depth at the pixel's middle by its slope.
            const double slope = glm::length(Vec2d(area.x, area.y)) / area.z;
            on_top = -point.z <= target_.depth[at] + target_.pixel * (0.5 + slope);
        }
        (on_top ? target_.direct : target_.indirect)[at] += effect;
    }

private:
    std::uint32_t pixel_of(double x, double origin) const {
        const double pixel = std::floor((x - origin) / target_.pixel);
        return static_cast<std::uint32_t>(std::clamp(pixel, 0.0, static_cast<double>(target_.size - 1)));
    }
    std::size_t pixel_at(const Vec3d& point) const {
        return target_.at(pixel_of(point.x, target_.origin.x), pixel_of(point.y, target_.origin.y));
    }
    static bool inside(const HullTriangle& t, double turn, const Vec2d& p) {
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3d& a = t[k];
            const Vec3d& b = t[(k + 1) % 3];
            const double side = (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
            if (turn > 0.0 ? side < 0.0 : side > 0.0) return false;
        }
        return true;
    }
    void put(std::size_t at, double depth, double normal_z) {
        if (target_.filled[at] != 0 && target_.depth[at] <= depth) return;
        target_.filled[at] = 1;
        target_.depth[at] = depth;
        normal_z_[at] = normal_z;
    }
    double of_neighbours(std::uint32_t column, std::uint32_t row) const {
        double greatest = 0.0;
        if (column > 0) greatest = std::max(greatest, normal_z_[target_.at(column - 1, row)]);
        if (row > 0) greatest = std::max(greatest, normal_z_[target_.at(column, row - 1)]);
        if (column + 1 < target_.size) greatest = std::max(greatest, normal_z_[target_.at(column + 1, row)]);
        if (row + 1 < target_.size) greatest = std::max(greatest, normal_z_[target_.at(column, row + 1)]);
        return greatest;
    }

    Silhouette& target_;
    std::vector<double>& normal_z_;
    std::vector<std::uint8_t>& rim_;
};

void make_empty(std::uint32_t size, double pixel, const Vec2d& origin, Silhouette& silhouette) {
    silhouette.size = 4;
    while (silhouette.size < size && silhouette.size < 64)
        silhouette.size *= 2;
    silhouette.pixel = pixel;
    silhouette.origin = origin;
    const std::size_t count = std::size_t{silhouette.size} * silhouette.size;
    silhouette.filled.assign(count, 0);
    silhouette.submerged.assign(count, 0);
    silhouette.depth.assign(count, 0.0);
    silhouette.direct.assign(count, 0.0);
    silhouette.indirect.assign(count, 0.0);
}

/// The square around the wet part, a pixel wider on each side.
void fit(std::span<const HullTriangle> wet, std::uint32_t size, Silhouette& silhouette) {
    constexpr double unbounded = std::numeric_limits<double>::max();
    Vec2d least(unbounded);
    Vec2d greatest(-unbounded);
    for (const HullTriangle& t : wet)
        for (const Vec3d& corner : t) {
            least = {std::min(least.x, corner.x), std::min(least.y, corner.y)};
            greatest = {std::max(greatest.x, corner.x), std::max(greatest.y, corner.y)};
        }
    make_empty(size, 1.0, Vec2d(0.0), silhouette);
    if (wet.empty()) return;
    const Vec2d extent = greatest - least;
    const double pixels = static_cast<double>(silhouette.size - 2);
    silhouette.pixel = std::max({extent.x / pixels, extent.y / pixels, 1e-3});
    silhouette.origin =
        0.5 * (least + greatest) - Vec2d(0.5 * silhouette.pixel * static_cast<double>(silhouette.size));
}

} // namespace

Silhouette empty_silhouette(std::uint32_t size, double pixel, const Vec2d& origin) {
    Silhouette silhouette;
    make_empty(size, pixel, origin, silhouette);
    return silhouette;
}

Silhouette draw_silhouette(std::span<const HullTriangle> hull, const HullMotion& motion, std::uint32_t size) {
    Silhouette silhouette;
    SilhouetteScratch scratch;
    draw_silhouette(hull, motion, size, scratch, silhouette);
    return silhouette;
}

void draw_silhouette(std::span<const HullTriangle> hull, const HullMotion& motion, std::uint32_t size,
                     SilhouetteScratch& scratch, Silhouette& silhouette) {
    std::vector<HullTriangle>& wet = scratch.wet;
    wet.clear();
    for (const HullTriangle& triangle : hull) {
        HullTriangle world{};
        for (std::size_t k = 0; k < 3; ++k)
            world[k] = motion.world_from_body * triangle[k] + motion.position;
        cut_at_surface(world, wet);
    }
    fit(wet, size, silhouette);
    Drawing drawing(silhouette, scratch);
    for (const HullTriangle& triangle : wet)
        drawing.fill(triangle);
    constexpr int most_halvings = 16; // 65,536 pieces of a face: a face of 250 pixels by 250
    const auto for_each_piece = [&](auto each) {
        for (const HullTriangle& triangle : wet)
            for_each_small(triangle, silhouette.pixel, most_halvings, [&](const HullTriangle& piece) {
                const Vec3d middle = (piece[0] + piece[1] + piece[2]) / 3.0;
                each(middle, 0.5 * glm::cross(piece[1] - piece[0], piece[2] - piece[0]));
            });
    };
    for_each_piece([&](const Vec3d& middle, const Vec3d& area) {
        const double size_of = glm::length(area);
        if (size_of > 0.0) drawing.fill_point(middle, area.z / size_of);
    });
    drawing.settle();
    for_each_piece([&](const Vec3d& middle, const Vec3d& area) {
        const Vec3d velocity =
            motion.velocity_mps + glm::cross(motion.turn_rate_rad_s, middle - motion.position);
        drawing.add_effect(middle, area, glm::dot(velocity, area));
    });
}

} // namespace linkdig::ig
