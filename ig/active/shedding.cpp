#include "ig/active/shedding.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace linkdig::ig {

namespace {

constexpr float endless = std::numeric_limits<float>::infinity();

/// Not fewer than a face can have on the raster: a smooth one is cut into triangles.
std::uint32_t edges_of(const Face& face) {
    const bool cut = face.shading == Shading::vertex || face.coloured != 0;
    return cut ? 3U * (face.corner_count - 2U) : face.corner_count;
}

struct Bounds {
    Vec3f least{endless};
    Vec3f greatest{-endless};
    bool infinite = false;
};

/// Where a channel looks: a cone about its frustum.
struct Cone {
    Vec3d eye_m{0};
    Vec3d axis{1, 0, 0};
    double tangent = 1;     ///< of its half angle
    double lengthening = 1; ///< of a distance across, along the cone's side
    double px_per_tangent = 1;
};

Cone cone_of(const ChannelView& channel, const Raster& raster) {
    const double across = std::max(std::fabs(channel.left_tangent), std::fabs(channel.right_tangent));
    const double up = std::max(std::fabs(channel.bottom_tangent), std::fabs(channel.top_tangent));
    Cone cone{.eye_m = channel.eye_m, .axis = world_from_body(channel.attitude)[0]};
    cone.tangent = std::sqrt(across * across + up * up);
    cone.lengthening = std::sqrt(1.0 + cone.tangent * cone.tangent);
    cone.px_per_tangent = raster.width / (channel.right_tangent - channel.left_tangent);
    return cone;
}

/// How large a sphere looks, in pixels; 0 out of sight, endless around the eye.
double size_px(const Cone& cone, const Vec3d& centre, double radius) {
    const Vec3d to = centre - cone.eye_m;
    const double range = glm::length(to);
    if (range <= radius) return std::numeric_limits<double>::infinity();
    const double along = glm::dot(to, cone.axis);
    const double across = glm::length(to - along * cone.axis);
    if (across > along * cone.tangent + radius * cone.lengthening) return 0.0;
    return 2.0 * radius / range * cone.px_per_tangent;
}

/// On the channel where the object looks largest.
double largest_px(const FramePacket& packet, const Raster& raster, const FaceBlock& block,
                  const ObjectWorth& worth) {
    if (worth.radius < 0.0F || block.at_eye) return std::numeric_limits<double>::infinity();
    const Vec3d centre = block.origin_m + block.world_from_list * Vec3d(worth.centre);
    double largest = 0.0;
    for (const ChannelView& channel : packet.channels)
        if (channel.on)
            largest = std::max(largest,
                               size_px(cone_of(channel, raster), centre, static_cast<double>(worth.radius)));
    return largest;
}

} // namespace

std::vector<ObjectWorth> object_worths(const VisualDatabase& database) {
    std::vector<ObjectWorth> worths(database.objects.size());
    std::vector<Bounds> bounds(database.objects.size());
    for (const Face& face : database.faces) {
        worths[face.object].edges += edges_of(face);
        Bounds& box = bounds[face.object];
        for (std::uint32_t k = 0; k < face.corner_count; ++k) {
            const Vec4f& p = database.vertices[database.corners[face.first_corner + k]].position;
            box.infinite = box.infinite || p.w == 0.0F;
            box.least = glm::min(box.least, Vec3f(p));
            box.greatest = glm::max(box.greatest, Vec3f(p));
        }
    }
    for (std::size_t o = 0; o < worths.size(); ++o) {
        if (worths[o].edges == 0 || bounds[o].infinite) continue; // a tile's object, a sky: never small
        worths[o].centre = 0.5F * (bounds[o].least + bounds[o].greatest);
        worths[o].radius = 0.5F * glm::length(bounds[o].greatest - bounds[o].least);
    }
    return worths;
}

void shed_objects(const VisualDatabase& database, const FramePacket& packet, const Raster& raster,
                  std::uint32_t step, ActiveDatabase& active) {
    active.object_px.assign(database.objects.size(), 0.0); // out of sight, too
    active.object_shed.assign(database.objects.size(), 0);
    active.block_of_list.assign(database.lists.size(), none);
    for (std::size_t b = 0; b < active.blocks.size(); ++b)
        active.block_of_list[active.blocks[b].list] = static_cast<std::int32_t>(b);
    const double least = least_size_px(step);
    for (std::size_t o = 0; o < database.objects.size(); ++o) {
        const std::int32_t block = active.block_of_list[database.objects[o].list];
        if (block == none) continue;
        active.object_px[o] = largest_px(packet, raster, active.blocks[static_cast<std::size_t>(block)],
                                         active.object_worth[o]);
        active.object_shed[o] = active.object_px[o] > 0.0 && active.object_px[o] < least ? 1 : 0;
    }
}

} // namespace linkdig::ig
