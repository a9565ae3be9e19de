// Semi-opaque faces and lists that are added: shares of a pixel, front to back.

#include "tests/ig/small_database.h"

#include "database/model/mathematics.h"
#include "ig/geometry/projected_face.h"
#include "ig/machine/machine.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

namespace linkdig::ig {
namespace {

constexpr std::uint32_t side = 32;
constexpr std::size_t middle = side * side / 2 + side / 2;

/// Walls across the line of sight, each a cluster of its own, nearest first; the lists' numbers are 1 to the wall's.
VisualDatabase walls(std::size_t count) {
    VisualDatabase database = sea_database();
    database.tiles.clear();
    database.lists[0].tile = none;
    database.groups.clear();
    for (std::size_t k = 0; k <= count; ++k) {
        database.groups.push_back({.number = static_cast<std::int32_t>(k), .root = none});
    }
    database.clusters[0].group = static_cast<std::uint32_t>(count);
    for (std::size_t k = 0; k < count; ++k) {
        const float x = 10.0F + 5.0F * static_cast<float>(k);
        add_box(database, {.from = {x, -30, -30},
                           .to = {x + 1, 30, 30},
                           .colour = static_cast<std::uint16_t>(1 + k),
                           .group = static_cast<std::uint32_t>(k)});
    }
    return database;
}

std::uint32_t look(const VisualDatabase& database, bool smoothing) {
    Configuration configuration;
    configuration.raster = {side, side, Scan::horizontal};
    configuration.edge_smoothing = smoothing;
    configuration.threads = 1;
    Machine machine(database, configuration);
    FramePacket packet;
    packet.channels = {channel_at({0, 0, 0})};
    packet.suns = {{0, 0, 1}};
    packet.sky = {0, 0, 0};
    EXPECT_TRUE(machine.frame(packet).errors.empty());
    return machine.picture(0).pixels[middle];
}

void expect_pixel(std::uint32_t pixel, double red, double green, double blue) {
    EXPECT_NEAR(static_cast<double>(pixel & 0xffU), red, 1.0);
    EXPECT_NEAR(static_cast<double>(pixel >> 8U & 0xffU), green, 1.0);
    EXPECT_NEAR(static_cast<double>(pixel >> 16U & 0xffU), blue, 1.0);
}

void set_opacity(VisualDatabase& database, std::size_t wall, std::uint16_t opacity) {
    for (std::size_t f = 6 * wall; f < 6 * wall + 6; ++f)
        database.faces[f].opacity = opacity;
}

TEST(Blending, SemiOpaqueFacesTakeTheirPartOfWhatIsLeft) {
    for (const bool smoothing : {false, true}) {
        VisualDatabase database = walls(3);
        database.colours = {{}, {200, 0, 0, 0}, {0, 200, 0, 0}, {0, 0, 200, 0}};
        expect_pixel(look(database, smoothing), 200, 0, 0);
        set_opacity(database, 0, 64); // a quarter
        expect_pixel(look(database, smoothing), 50, 150, 0);
        set_opacity(database, 1, 128); // a half of the other three
        expect_pixel(look(database, smoothing), 50, 75, 75);
        set_opacity(database, 2, 128); // and black behind
        expect_pixel(look(database, smoothing), 50, 75, 37.5);
    }
}

TEST(Blending, AddedLightCountsOverItsPartnerAlone) {
    for (const bool smoothing : {false, true}) {
        VisualDatabase database = walls(3);
        database.colours = {{}, {60, 50, 40, 0}, {10, 100, 20, 0}, {90, 90, 90, 0}};
        const std::int32_t first_wall = 1; // list 0 is the empty sea
        database.lists[first_wall].added_to = first_wall + 1;
        expect_pixel(look(database, smoothing), 70, 150, 60);
        database.lists[first_wall].added_to = first_wall + 2; // the wall between is not the partner
        expect_pixel(look(database, smoothing), 10, 100, 20);
        database.lists[first_wall].added_to = 0; // nor is the sea, which is not there
        expect_pixel(look(database, smoothing), 10, 100, 20);
    }
}

TEST(Blending, AddedLightIsClampedOnce) {
    VisualDatabase database = walls(3);
    database.colours = {{}, {200, 200, 10, 0}, {200, 10, 10, 0}, {200, 60, 10, 0}};
    database.lists[1].added_to = 3;
    database.lists[2].added_to = 3; // two lists over one partner
    expect_pixel(look(database, false), 255, 255, 30);
}

TEST(Blending, TheSeaAndAWakeOverItAddUpLevelByLevel) {
    // The report's hardware modification: the wake's intensities are added to the sea's (3.2.3).
    // With smoothed edges too: the seams of the sea's squares are brightened like their insides.
    for (const bool smoothing : {false, true}) {
        VisualDatabase database = sea_database();
        Configuration configuration;
        configuration.raster = {64, 64, Scan::horizontal};
        configuration.edge_smoothing = smoothing;
        FramePacket packet;
        packet.channels = {channel_at({0, 0, 20}, 0, -60)};
        packet.suns = {Vec3f(direction(0.4, radians(30.0)))};
        Machine sea(database, configuration);
        sea.draw_planes(true, false);
        sea.frame(packet);
        const VideoFrame alone = sea.picture(0);

        database.groups.insert(database.groups.begin(), {.number = 1, .root = none});
        database.clusters[0].group = 1;
        database.colours[1] = {30, 30, 30, 0};
        add_box(database, {.from = {-200, -200, 0.01F}, .to = {200, 200, 0.02F}, .colour = 1, .group = 0});
        database.lists[1].added_to = 0;
        Machine both(database, configuration);
        both.frame(packet);
        for (std::size_t k = 0; k < alone.pixels.size(); ++k) {
            for (int shift = 0; shift < 24; shift += 8) {
                const int sum = static_cast<int>(alone.pixels[k] >> shift & 0xffU) + 30;
                ASSERT_NEAR(static_cast<int>(both.picture(0).pixels[k] >> shift & 0xffU), std::min(sum, 255),
                            1)
                    << k;
            }
        }
    }
}

} // namespace
} // namespace linkdig::ig
