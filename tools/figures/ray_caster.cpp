#include "tools/figures/ray_caster.h"

#include "tools/figures/stage.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace linkdig::tools {
namespace {

/// Distance in lengths of the ray, or negative: Möller and Trumbore's solution
/// of eye + t ray = a + u (b - a) + v (c - a).
double meets(const Vec3d& eye, const Vec3d& ray, const std::array<Vec3d, 3>& triangle) {
    const Vec3d ab = triangle[1] - triangle[0];
    const Vec3d ac = triangle[2] - triangle[0];
    const Vec3d across = glm::cross(ray, ac);
    const double determinant = glm::dot(ab, across);
    if (std::fabs(determinant) < 1e-12) return -1.0;
    const Vec3d from = eye - triangle[0];
    const double u = glm::dot(from, across) / determinant;
    if (u < 0.0 || u > 1.0) return -1.0;
    const Vec3d along = glm::cross(from, ab);
    const double v = glm::dot(ray, along) / determinant;
    if (v < 0.0 || u + v > 1.0) return -1.0;
    return glm::dot(ac, along) / determinant;
}

/// Pixels that a triangle can cover: all, if it reaches behind the eye.
struct Box {
    std::int64_t left, right, top, bottom; ///< last ones included
};

Box box_of(const std::array<Vec3d, 3>& triangle, const ChannelView& channel, const Mat3d& eye_from_world,
           std::int64_t width, std::int64_t height) {
    Box box{width, -1, height, -1};
    for (const Vec3d& corner : triangle) {
        const Vec3d seen = eye_from_world * (corner - channel.eye_m);
        if (seen.x < 0.01) return {0, width - 1, 0, height - 1};
        const double x =
            (-seen.y / seen.x - channel.left_tangent) / (channel.right_tangent - channel.left_tangent);
        const double y =
            (channel.top_tangent - seen.z / seen.x) / (channel.top_tangent - channel.bottom_tangent);
        const double most = 1e6;
        const auto column =
            static_cast<std::int64_t>(std::floor(std::clamp(x * static_cast<double>(width), -most, most)));
        const auto row =
            static_cast<std::int64_t>(std::floor(std::clamp(y * static_cast<double>(height), -most, most)));
        box = {std::min(box.left, column - 1), std::max(box.right, column + 1), std::min(box.top, row - 1),
               std::max(box.bottom, row + 1)};
    }
    return {std::max<std::int64_t>(box.left, 0), std::min(box.right, width - 1),
            std::max<std::int64_t>(box.top, 0), std::min(box.bottom, height - 1)};
}

/// Of an object with levels of detail only the finest counts: a coarser one stands out here and there.
bool is_finest(const VisualDatabase& database, std::int32_t level) {
    if (level <= 0) return true; // none, or the first of all
    const auto index = static_cast<std::size_t>(level);
    return database.detail_levels[index].detail != database.detail_levels[index - 1].detail;
}

bool counts(const VisualDatabase& database, const Face& face, const std::string& ship, ShipPart part) {
    const Object& object = database.objects[face.object];
    const ObjectList& list = database.lists[object.list];
    if (database.clusters[list.cluster].name != ship || list.attachment != Attachment::body) return false;
    if (!is_finest(database, object.level)) return false;
    if (object.slot == none) return part == ShipPart::whole;
    return database.slots[static_cast<std::size_t>(object.slot)].name == ship + ".hull_below" &&
           object.alternative == 1;
}

} // namespace

ShipTriangles ship_triangles(const VisualDatabase& database, const std::string& ship, ShipPart part) {
    ShipTriangles made;
    for (const Face& face : database.faces) {
        if (!counts(database, face, ship, part)) continue;
        const Vec3d origin = database.lists[database.objects[face.object].list].origin_m;
        const auto corner = [&](std::uint32_t k) {
            return origin + Vec3d(Vec3f(database.vertices[database.corners[face.first_corner + k]].position));
        };
        for (std::uint32_t k = 1; k + 1 < face.corner_count; ++k)
            made.triangles.push_back({corner(0), corner(k), corner(k + 1)});
    }
    return made;
}

std::vector<Hit> cast(const ShipTriangles& ship, const MovingObject& pose, const ChannelView& channel,
                      std::uint32_t width, std::uint32_t height) {
    const std::size_t pixels = std::size_t{width} * height;
    std::vector<Vec3d> rays(pixels);
    std::vector<double> nearest(pixels, 1e30);
    std::vector<Hit> hits(pixels, Hit::sky);
    const Mat3d world_from_eye = world_from_body(channel.attitude);
    for (std::size_t i = 0; i < pixels; ++i) {
        const std::size_t row = i / width, column = i % width;
        rays[i] = ray_through(channel, world_from_eye, (static_cast<double>(column) + 0.5) / width,
                              (static_cast<double>(row) + 0.5) / height);
        if (rays[i].z >= 0.0) continue;
        nearest[i] = -channel.eye_m.z / rays[i].z;
        hits[i] = Hit::sea;
    }
    const Mat3d world_from_ship = world_from_body(pose.attitude);
    const Mat3d eye_from_world = glm::transpose(world_from_eye);
    for (std::array<Vec3d, 3> triangle : ship.triangles) {
        for (Vec3d& corner : triangle)
            corner = pose.position_m + world_from_ship * corner;
        const Box box = box_of(triangle, channel, eye_from_world, width, height);
        for (std::int64_t y = box.top; y <= box.bottom; ++y) {
            for (std::int64_t x = box.left; x <= box.right; ++x) {
                const auto i = static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x);
                const double distance = meets(channel.eye_m, rays[i], triangle);
                if (distance <= 0.0 || distance >= nearest[i]) continue;
                nearest[i] = distance;
                hits[i] = Hit::ship;
            }
        }
    }
    return hits;
}

} // namespace linkdig::tools
