#include "tools/bench/scene.h"

#include "database/model/mathematics.h"
#include "database/model/random.h"
#include "database/model/rotation.h"
#include "tools/bench/scene_builder.h"

namespace linkdig::bench {

namespace {

struct Colours {
    std::uint16_t grass, field, concrete, asphalt, paint, wall;
};

/// 240 buildings of five faces beside the runway, those that are nearer first.
void add_buildings(SceneBuilder& builder, std::uint16_t wall) {
    builder.begin_list("buildings", 0);
    for (std::uint32_t k = 0; k < 240; ++k) {
        const auto unit = [k](std::uint64_t n) { return static_cast<float>(random_unit(n, k)); };
        const float x = 300.0F + 16.0F * static_cast<float>(k);
        const float side = k % 2 == 0 ? 1.0F : -1.0F;
        const float y = side * (180.0F + 400.0F * unit(1));
        builder.box({x, y - 12.0F, 0.0F}, {x + 14.0F, y + 12.0F, 4.0F + 20.0F * unit(2)}, wall);
    }
}

/// 496 stripes: threshold, centreline, edges, touchdown zone.
void add_markings(SceneBuilder& builder, std::uint16_t paint) {
    builder.begin_list("markings", 0);
    for (std::uint32_t k = 0; k < 496; ++k) {
        const float x = 60.0F + 60.0F * static_cast<float>(k / 8);
        const float y = -28.0F + 8.0F * static_cast<float>(k % 8);
        builder.rectangle({x, y - 0.7F}, {x + 30.0F, y + 0.7F}, 0.0F, paint);
    }
}

/// Runway, taxiways and ramps over 250 fields of grass: large faces, 54 and 250 of them.
void add_ground(SceneBuilder& builder, const Colours& colours) {
    builder.begin_list("paved", 0);
    builder.rectangle({0.0F, -45.0F}, {3600.0F, 45.0F}, 0.0F, colours.asphalt);
    for (std::uint32_t k = 0; k < 53; ++k) {
        const float x = 70.0F * static_cast<float>(k);
        builder.rectangle({x, k % 2 == 0 ? 45.0F : -230.0F}, {x + 66.0F, k % 2 == 0 ? 230.0F : -45.0F}, 0.0F,
                          colours.concrete);
    }
    builder.begin_list("grass", 0);
    for (std::uint32_t k = 0; k < 250; ++k) {
        const float x = -500.0F + 800.0F * static_cast<float>(k / 10);
        const float y = -4000.0F + 800.0F * static_cast<float>(k % 10);
        builder.rectangle({x, y}, {x + 800.0F, y + 800.0F}, 0.0F, k % 3 == 0 ? colours.field : colours.grass);
    }
}

} // namespace

Scene airfield_scene() {
    Scene scene;
    scene.name = "airfield";
    SceneBuilder builder(scene.database, scene.name);
    const Colours colours{
        builder.colour("grass", {70, 110, 60, 0}),      builder.colour("field", {96, 122, 64, 0}),
        builder.colour("concrete", {150, 150, 145, 0}), builder.colour("asphalt", {80, 80, 84, 0}),
        builder.colour("paint", {235, 235, 230, 0}),    builder.colour("wall", {170, 150, 130, 0})};
    add_buildings(builder, colours.wall);
    add_markings(builder, colours.paint);
    add_ground(builder, colours);
    scene.packet = [](std::uint64_t frame) {
        const double t = 0.02 * static_cast<double>(frame % 100);
        FramePacket packet;
        packet.frame = frame;
        ChannelView channel;
        channel.eye_m = {-300.0 + t, 0.5 * t, 45.0};
        channel.attitude = {.heading_rad = 0.02 * t, .pitch_rad = -0.15};
        packet.channels = {channel};
        packet.suns = {Vec3f(direction(2.0, 0.8)), Vec3f(0, 0, 1)};
        packet.sky = {0.73F, 0.81F, 0.87F};
        return packet;
    };
    return scene;
}

} // namespace linkdig::bench
