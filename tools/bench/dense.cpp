#include "tools/bench/scene.h"

#include "database/model/mathematics.h"
#include "database/model/random.h"
#include "database/model/rotation.h"
#include "tools/bench/scene_builder.h"

#include <array>
#include <cmath>

namespace linkdig::bench {

namespace {

/// Area of a picture of 60 by 60 degrees in tangents, and its half side.
constexpr double half_side = 0.577;
constexpr double picture_area = 4.0 * half_side * half_side;

} // namespace

Scene dense_scene(std::uint32_t triangles) {
    Scene scene;
    scene.name = "dense";
    SceneBuilder builder(scene.database, scene.name);
    std::array<std::uint16_t, 8> colours{};
    for (std::size_t c = 0; c < colours.size(); ++c) {
        const auto part = [c](unsigned n) { return static_cast<std::uint8_t>(60 + 180 * random_unit(n, c)); };
        colours[c] = builder.colour("colour " + std::to_string(c), {part(1), part(2), part(3), 0});
    }
    // An equilateral triangle of circumradius r covers 3 sqrt(3) / 4 r^2; sizes spread by a factor of two around that of
    // depth complexity 3 (the mean square of 0.6 to 1.3 is 0.94).
    const double radius = std::sqrt(3.0 * picture_area / triangles / (0.94 * 0.75 * std::sqrt(3.0)));
    builder.begin_list("triangles", 0);
    for (std::uint32_t k = 0; k < triangles; ++k) {
        const auto unit = [k](std::uint64_t n) { return random_unit(n, k); };
        const double depth = 100.0 + 0.02 * k * 20000.0 / triangles; // nearer ones first
        const double y = (2.0 * unit(11) - 1.0) * half_side, z = (2.0 * unit(12) - 1.0) * half_side;
        const double turn = two_pi * unit(13), size = radius * (0.6 + 0.7 * unit(14));
        std::array<std::uint32_t, 3> corners{};
        for (std::uint32_t c = 0; c < 3; ++c) {
            const Vec3d to = direction(turn - two_pi * c / 3.0, 0.0);
            corners[c] =
                builder.vertex(Vec3f(Vec3d(depth, depth * (y + size * to.x), depth * (z + size * to.y))),
                               Vec3f(direction(two_pi * unit(20 + c), 0.4)));
        }
        builder.face(corners, colours[k % colours.size()], Shading::vertex);
    }
    scene.packet = [](std::uint64_t frame) {
        const double t = 0.02 * static_cast<double>(frame % 100);
        FramePacket packet;
        packet.frame = frame;
        ChannelView channel;
        channel.eye_m = {0.05 * t, 0.1 * t, 0.0};
        packet.channels = {channel};
        packet.suns = {Vec3f(direction(2.0 + t, 0.8)), Vec3f(0, 0, 1)};
        return packet;
    };
    return scene;
}

} // namespace linkdig::bench
