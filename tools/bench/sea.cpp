#include "tools/bench/scene.h"

#include "database/model/mathematics.h"
#include "database/model/random.h"
#include "database/model/rotation.h"
#include "tools/bench/scene_builder.h"

#include <array>

namespace linkdig::bench {

namespace {

constexpr std::uint32_t squares = 64;
constexpr float square_m = 300.0F;

/// Hull and superstructure: 30 x 46 smooth quads around a spindle, then 24 boxes of five faces on its deck; 1,500 faces.
void add_ship(SceneBuilder& builder, std::uint16_t hull, std::uint16_t house) {
    builder.begin_list("superstructure", 0);
    for (std::uint32_t k = 0; k < 24; ++k) {
        const float x = 200.0F + 4.0F * static_cast<float>(k);
        const float y = k % 2 == 0 ? 1.0F : -5.0F;
        builder.box({x, y, 14.0F}, {x + 3.0F, y + 4.0F, 17.0F + static_cast<float>(k % 5)}, house);
    }
    builder.begin_list("hull", 0);
    constexpr std::uint32_t sections = 46, around = 30;
    std::vector<std::uint32_t> ring;
    for (std::uint32_t s = 0; s <= sections; ++s) {
        const double along = static_cast<double>(s) / sections;
        const double width = 13.0 * (1.0 - (2.0 * along - 1.0) * (2.0 * along - 1.0)) + 0.5;
        for (std::uint32_t a = 0; a < around; ++a) {
            const Vec3d out = direction(0.0, two_pi * a / around);
            const Vec3f normal(0.0F, static_cast<float>(out.x), static_cast<float>(out.z));
            ring.push_back(builder.vertex(Vec3f(static_cast<float>(170.0 + 160.0 * along),
                                                static_cast<float>(width * out.x),
                                                static_cast<float>(4.0 + 10.0 * out.z)),
                                          normal));
        }
    }
    for (std::uint32_t s = 0; s < sections; ++s) {
        for (std::uint32_t a = 0; a < around; ++a) {
            const std::uint32_t b = (a + 1) % around;
            const std::array corners{ring[s * around + a], ring[s * around + b], ring[(s + 1) * around + b],
                                     ring[(s + 1) * around + a]};
            builder.face(corners, hull, Shading::vertex);
        }
    }
}

void add_water(SceneBuilder& builder, std::uint16_t colour) {
    builder.begin_list("water", 1);
    std::vector<std::uint32_t> grid;
    for (std::uint32_t y = 0; y <= squares; ++y) {
        for (std::uint32_t x = 0; x <= squares; ++x) {
            const double azimuth = two_pi * random_unit(1979, grid.size());
            grid.push_back(builder.vertex(Vec3f(square_m * static_cast<float>(x),
                                                square_m * (static_cast<float>(y) - 0.5F * squares), 0.0F),
                                          Vec3f(direction(azimuth, radians(68.0)))));
        }
    }
    for (std::uint32_t y = 0; y < squares; ++y) {
        for (std::uint32_t x = 0; x < squares; ++x) {
            const std::uint32_t corner = y * (squares + 1) + x;
            const std::array corners{grid[corner], grid[corner + 1], grid[corner + squares + 2],
                                     grid[corner + squares + 1]};
            builder.face(corners, colour, Shading::vertex);
        }
    }
}

/// Bands of a dome at infinity; only the half ahead.
void add_sky(SceneBuilder& builder, std::uint16_t colour) {
    builder.begin_list("sky", 0, Attachment::eye);
    constexpr std::uint32_t sectors = 8;
    static constexpr std::array elevations_deg{0.0, 5.0, 25.0, 89.0};
    std::vector<std::uint32_t> dome;
    for (const double elevation_deg : elevations_deg) {
        for (std::uint32_t s = 0; s <= sectors; ++s) {
            const Vec3d to = direction(pi * (static_cast<double>(s) / sectors - 0.5), radians(elevation_deg));
            dome.push_back(builder.vertex(Vec4f(Vec3f(to), 0.0F), Vec3f(0, 0, 1.0F)));
        }
    }
    for (std::uint32_t ring = 0; ring + 1 < elevations_deg.size(); ++ring) {
        for (std::uint32_t s = 0; s < sectors; ++s) {
            const std::uint32_t a = ring * (sectors + 1) + s;
            builder.face(std::array{dome[a + 1], dome[a], dome[a + sectors + 1], dome[a + sectors + 2]},
                         colour, Shading::unshaded);
        }
    }
}

} // namespace

Scene sea_scene() {
    Scene scene;
    scene.name = "sea";
    SceneBuilder builder(scene.database, scene.name);
    const std::uint16_t hull = builder.colour("hull", {120, 125, 130, 0});
    const std::uint16_t house = builder.colour("house", {150, 155, 160, 0});
    const std::uint16_t water = builder.colour("water", {58, 117, 149, 0});
    const std::uint16_t sky = builder.colour("sky", {187, 207, 221, 0});
    add_ship(builder, hull, house);
    add_water(builder, water);
    add_sky(builder, sky);
    scene.packet = [](std::uint64_t frame) {
        const double t = 0.02 * static_cast<double>(frame % 100);
        FramePacket packet;
        packet.frame = frame;
        ChannelView channel;
        channel.eye_m = {-10.0 + t, 0.5 * t, 30.0};
        channel.attitude = {.heading_rad = 0.02 * t, .pitch_rad = -0.05};
        packet.channels = {channel};
        packet.suns = {Vec3f(direction(2.0, 0.8)), Vec3f(direction(t, radians(30.0)))};
        return packet;
    };
    return scene;
}

} // namespace linkdig::bench
