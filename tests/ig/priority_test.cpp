// Priority against a ray caster that knows distance: the order must show what is nearest, wherever planes can
// decide.

#include "tests/ig/small_database.h"

#include "database/model/mathematics.h"
#include "database/model/random.h"
#include "ig/active/activate.h"
#include "ig/machine/machine.h"
#include "ig/priority/prioritise.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace linkdig::ig {
namespace {

struct Body {
    Vec3d centre_m{0};
    Mat3d world_from_body{1.0};
    Vec3d half_m{1};
    std::uint32_t cluster = 0;
};

/// Distance along the ray at which it enters the box, by the slab method.
std::optional<double> enters(const Body& body, const Vec3d& eye, const Vec3d& direction_of_ray) {
    const Vec3d origin = glm::transpose(body.world_from_body) * (eye - body.centre_m);
    const Vec3d along = glm::transpose(body.world_from_body) * direction_of_ray;
    double near_m = 0.0;
    double far_m = 1e30;
    for (int axis = 0; axis < 3; ++axis) {
        const double a = (-body.half_m[axis] - origin[axis]) / along[axis];
        const double b = (body.half_m[axis] - origin[axis]) / along[axis];
        near_m = std::max(near_m, std::min(a, b));
        far_m = std::min(far_m, std::max(a, b));
    }
    if (near_m >= far_m) return {};
    return near_m;
}

/// The ray through the middle of a pixel.
Vec3d ray(const ChannelView& channel, std::uint32_t side, std::uint32_t row, std::uint32_t column) {
    const Mat3d body = world_from_body(channel.attitude);
    const double x = channel.left_tangent + (channel.right_tangent - channel.left_tangent) * (column + 0.5) /
                                                static_cast<double>(side);
    const double y = channel.top_tangent -
                     (channel.top_tangent - channel.bottom_tangent) * (row + 0.5) / static_cast<double>(side);
    return body[0] - x * body[1] + y * body[2];
}

double between(std::uint64_t seed, std::uint64_t index, double least, double greatest) {
    return least + (greatest - least) * random_unit(seed, index);
}

/// Pixels that show another cluster than the ray caster says, edges (where neighbours differ) left out.
int wrong_pixels(const VisualDatabase& database, const Machine& machine, const ChannelView& channel,
                 const std::vector<Body>& bodies, std::uint32_t side) {
    std::vector<std::int32_t> shown(side * side, none);
    std::vector<std::int32_t> expected(side * side, none);
    for (std::uint32_t k = 0; k < side * side; ++k) {
        const std::int32_t rank = machine.picture(0).rank[k];
        if (rank >= 0)
            shown[k] = static_cast<std::int32_t>(database.lists[machine.source(0, rank).list].cluster);
        double nearest = 1e30;
        for (const Body& body : bodies) {
            const auto distance = enters(body, channel.eye_m, ray(channel, side, k / side, k % side));
            if (!distance || *distance >= nearest) continue;
            nearest = *distance;
            expected[k] = static_cast<std::int32_t>(body.cluster);
        }
    }
    int wrong = 0;
    for (std::uint32_t row = 1; row + 1 < side; ++row) {
        for (std::uint32_t column = 1; column + 1 < side; ++column) {
            const std::uint32_t k = row * side + column;
            const bool inside = expected[k] == expected[k - 1] && expected[k] == expected[k + 1] &&
                                expected[k] == expected[k - side] && expected[k] == expected[k + side];
            if (inside && shown[k] != expected[k]) ++wrong;
        }
    }
    return wrong;
}

VisualDatabase empty_database() {
    VisualDatabase database = sea_database();
    database.lists[0].tile = none; // the sea stays out: only its group, as the last
    return database;
}

Configuration small_raster(std::uint32_t side) {
    Configuration configuration;
    configuration.raster.width = side;
    configuration.raster.height = side;
    configuration.threads = 1;
    return configuration;
}

TEST(Priority, LowerNumberWinsWhateverTheDistance) {
    VisualDatabase database = empty_database();
    database.groups = {
        {.number = 1, .root = none}, {.number = 2, .root = none}, {.number = 100, .root = none}};
    database.clusters[0].group = 2;
    add_box(database, {.from = {20, -3, -3}, .to = {26, 3, 3}, .colour = 1, .group = 0}); // far, number 1
    add_box(database, {.from = {10, -1, -1}, .to = {12, 1, 1}, .colour = 2, .group = 1}); // near, number 2
    Machine machine(database, small_raster(64));
    FramePacket packet;
    packet.channels = {channel_at({0, 0, 0})};
    packet.suns = {{0, 0, 1}};
    ASSERT_TRUE(machine.frame(packet).errors.empty());
    EXPECT_EQ(machine.picture(0).pixels[32 * 64 + 32] & 0xffffffU, 0x2828c8U); // red: the far one
}

/// A packet's own number takes a cluster out of its group; of equal numbers it comes after the whole group.
TEST(Priority, APacketGivesAClusterAnotherNumber) {
    VisualDatabase database = empty_database();
    database.groups = {
        {.number = 1, .root = none}, {.number = 2, .root = none}, {.number = 100, .root = none}};
    database.clusters[0].group = 2;
    const std::uint32_t far =
        add_box(database, {.from = {20, -3, -3}, .to = {26, 3, 3}, .colour = 1, .group = 0});
    const std::uint32_t near =
        add_box(database, {.from = {10, -1, -1}, .to = {12, 1, 1}, .colour = 2, .group = 1});
    Machine machine(database, small_raster(64));
    FramePacket packet;
    packet.channels = {channel_at({0, 0, 0})};
    packet.suns = {{0, 0, 1}};
    const auto seen = [&](std::vector<ClusterPriority> priorities) {
        packet.priorities = std::move(priorities);
        EXPECT_TRUE(machine.frame(packet).errors.empty());
        return machine.picture(0).pixels[32 * 64 + 32] & 0xffffffU;
    };
    const std::uint32_t first = seen({});
    const std::uint32_t second = seen({{far, 2}});
    EXPECT_NE(first, second) << "the far one has left the first group";
    EXPECT_EQ(seen({{far, 1}}), first) << "nothing else has its number";
    EXPECT_EQ(seen({{near, 0}}), second);
    EXPECT_EQ(seen({{near, 1}}), first) << "after the whole group of 1";
    EXPECT_EQ(seen({{far, 1000}}), second) << "behind the last group";
    EXPECT_EQ(seen({{far, 7}, {near, 8}}), first) << "two that left go by their numbers";
    EXPECT_EQ(seen({{far, 7}, {near, 8}, {far, 9}}), second) << "the later row counts";
    EXPECT_EQ(seen({}), first) << "for one frame alone";
    packet.priorities = {{3, 0}};
    EXPECT_EQ(machine.frame(packet).errors,
              std::vector<std::string>{"priorities[0].cluster is 3, but the database has 3 clusters"});
}

TEST(Priority, MovingClustersAreOrderedAsTheyLie) {
    constexpr std::uint32_t side = 96;
    VisualDatabase database = empty_database();
    database.groups = {{.number = 1, .root = none}, {.number = 100, .root = none}};
    database.clusters[0].group = 1;
    std::vector<Body> shapes;
    for (std::int32_t k = 0; k < 5; ++k) {
        const Vec3f half(4.0F + static_cast<float>(k), 1.5F, 1.0F);
        database.moving_objects.push_back("body " + std::to_string(k));
        const std::uint32_t cluster =
            add_box(database, {.from = -half, .to = half, .colour = 1, .group = 0, .moving_object = k});
        shapes.push_back({.half_m = Vec3d(half), .cluster = cluster});
    }
    Machine machine(database, small_raster(side));
    machine.draw_planes(false, true);
    int decided = 0;
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        std::vector<Body> bodies = shapes;
        FramePacket packet;
        packet.suns = {{0, 0, 1}};
        for (std::size_t k = 0; k < bodies.size(); ++k) {
            // One body in each of five lanes, at any heading: they never touch.
            MovingObject object;
            object.position_m = {between(seed, 10 * k, -30, 30), 22.0 * (static_cast<double>(k) - 2.0), 0.0};
            object.attitude = {between(seed, 10 * k + 1, 0.0, two_pi), between(seed, 10 * k + 2, -0.3, 0.3),
                               0.1};
            packet.moving_objects.push_back(object);
            bodies[k].centre_m = object.position_m;
            bodies[k].world_from_body = world_from_body(object.attitude);
        }
        const double azimuth = between(seed, 90, 0.0, two_pi);
        const double range = between(seed, 91, 70, 150);
        packet.channels = {channel_at({range * cosine(azimuth), range * sine(azimuth), 20.0},
                                      degrees(azimuth) + 180.0, -9.0)};
        const FrameReport& report = machine.frame(packet);
        ASSERT_TRUE(report.errors.empty()) << report.errors[0];
        if (report.channels[0].ambiguous_priorities == 0) {
            ++decided;
            EXPECT_EQ(wrong_pixels(database, machine, packet.channels[0], bodies, side), 0)
                << "seed " << seed;
        }
    }
    EXPECT_GT(decided, 190); // most of the time a plane decides
}

TEST(Priority, MovingClusterPassesAPierOnBothSides) {
    constexpr std::uint32_t side = 96;
    VisualDatabase database = empty_database();
    database.groups = {{.number = 1, .root = 0}, {.number = 100, .root = none}};
    database.clusters[0].group = 1;
    database.moving_objects = {"ship"};
    const std::uint32_t north = add_box(database, {.from = {-20, 12, -2}, .to = {20, 16, 2}, .colour = 1});
    const std::uint32_t south = add_box(database, {.from = {-20, -16, -2}, .to = {20, -12, 2}, .colour = 2});
    const std::uint32_t ship =
        add_box(database, {.from = {-6, -1.5, -3}, .to = {6, 1.5, 3}, .colour = 3, .moving_object = 0});
    // Two planes, one along each pier's water side: between them is the fairway.
    PlaneNode fairway;
    fairway.normal = {0, 1, 0};
    fairway.distance = 11.0F;
    fairway.front = leaf_reference(north);
    fairway.back = 1;
    database.planes.push_back(fairway);
    fairway.distance = -11.0F;
    fairway.front = none;
    fairway.back = leaf_reference(south);
    database.planes.push_back(fairway);
    Machine machine(database, small_raster(side));
    machine.draw_planes(false, true);
    for (int step = -10; step <= 10; ++step) {
        for (int view = 0; view < 12; ++view) {
            const double azimuth = two_pi * view / 12.0 + 0.05;
            FramePacket packet;
            packet.suns = {{0, 0, 1}};
            packet.moving_objects.resize(1);
            packet.moving_objects[0].position_m = {4.0 * step, 0.0, 0.0};
            packet.moving_objects[0].attitude.heading_rad = 0.02 * step;
            packet.channels = {channel_at({60 * cosine(azimuth), 60 * sine(azimuth), 14.0},
                                          degrees(azimuth) + 180.0, -13.0)};
            const FrameReport& report = machine.frame(packet);
            ASSERT_TRUE(report.errors.empty()) << report.errors[0];
            EXPECT_EQ(report.channels[0].ambiguous_priorities, 0U);
            const std::vector<Body> bodies = {{{0, 14, 0}, Mat3d(1.0), {20, 2, 2}, north},
                                              {{0, -14, 0}, Mat3d(1.0), {20, 2, 2}, south},
                                              {packet.moving_objects[0].position_m,
                                               world_from_body(packet.moving_objects[0].attitude),
                                               {6, 1.5, 3},
                                               ship}};
            EXPECT_EQ(wrong_pixels(database, machine, packet.channels[0], bodies, side), 0)
                << "step " << step << " view " << view;
        }
    }
}

TEST(Priority, CountsWhatNoPlaneDecides) {
    VisualDatabase database = empty_database();
    database.groups = {{.number = 1, .root = none}, {.number = 100, .root = none}};
    database.clusters[0].group = 1;
    database.moving_objects = {"one", "other"};
    for (std::int32_t k = 0; k < 2; ++k) {
        add_box(database,
                {.from = {-3, -3, -3}, .to = {3, 3, 3}, .colour = 1, .group = 0, .moving_object = k});
    }
    Machine machine(database, small_raster(32));
    FramePacket packet;
    packet.suns = {{0, 0, 1}};
    packet.channels = {channel_at({-40, 0, 0})};
    packet.moving_objects.resize(2);
    packet.moving_objects[1].position_m = {2, 1, 0}; // they intersect
    EXPECT_EQ(machine.frame(packet).channels[0].ambiguous_priorities, 1U);
    packet.moving_objects[1].position_m = {7, 1, 0};
    EXPECT_EQ(machine.frame(packet).channels[0].ambiguous_priorities, 0U);
}

} // namespace
} // namespace linkdig::ig
