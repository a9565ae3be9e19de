// The far sea: no crack, no pop, no sparkle, and a straight horizon at any height.

#include "tests/ig/small_database.h"

#include "database/model/mathematics.h"
#include "database/model/tile_tables.h"
#include "ig/machine/machine.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

namespace linkdig::ig {
namespace {

Configuration raster_of(std::uint32_t width, std::uint32_t height) {
    Configuration configuration;
    configuration.raster.width = width;
    configuration.raster.height = height;
    configuration.threads = 1;
    return configuration;
}

FramePacket packet_of(const ChannelView& channel, double sun_azimuth_rad = 0.4) {
    FramePacket packet;
    packet.channels = {channel};
    packet.suns = {Vec3f(direction(sun_azimuth_rad, radians(30.0)))};
    return packet;
}

int greatest_difference(const VideoFrame& a, const VideoFrame& b) {
    int greatest = 0;
    for (std::size_t k = 0; k < a.pixels.size(); ++k) {
        for (int shift = 0; shift < 24; shift += 8) {
            const int x = static_cast<int>(a.pixels[k] >> shift & 0xffU);
            const int y = static_cast<int>(b.pixels[k] >> shift & 0xffU);
            greatest = std::max(greatest, std::abs(x - y));
        }
    }
    return greatest;
}

TEST(RepeatedTile, HasNoCracks) {
    const VisualDatabase database = sea_database();
    Machine machine(database, raster_of(512, 512));
    machine.draw_planes(false, true);
    int views = 0;
    for (const double height_m : {1.0, 7.0, 30.0, 180.0, 2500.0}) {
        for (const double heading_deg : {0.0, 33.0, 135.0, 261.0}) {
            for (const double pitch_deg : {-90.0, -60.0, -35.0, -30.5}) { // the horizon is above the picture
                const Vec3d eye(1234.5 + heading_deg, -987.6, height_m);
                machine.frame(packet_of(channel_at(eye, heading_deg, pitch_deg, 20.0 * (pitch_deg < -50.0))));
                const auto& rank = machine.picture(0).rank;
                EXPECT_EQ(std::count(rank.begin(), rank.end(), none), 0)
                    << "height " << height_m << " heading " << heading_deg << " pitch " << pitch_deg;
                ++views;
            }
        }
    }
    EXPECT_EQ(views, 80);
}

TEST(RepeatedTile, HorizonIsTheSameLineAtAnyHeight) {
    const VisualDatabase database = sea_database();
    Machine machine(database, raster_of(256, 256));
    machine.draw_planes(false, true);
    for (const double height_m : {1.0, 30.0, 3000.0}) {
        machine.frame(packet_of(channel_at({10, 20, height_m}, 77.0)));
        const auto& rank = machine.picture(0).rank;
        for (std::size_t k = 0; k < rank.size(); ++k) {
            ASSERT_EQ(rank[k] == none, k / 256 < 128) << "height " << height_m << " row " << k / 256;
        }
    }
}

TEST(RepeatedTile, DoesNotPopWhenRingsMove) {
    // The innermost rings snap every 6 m, the next ones every 12, 24, 48 m: cross each of them by a
    // millimetre.
    const VisualDatabase database = sea_database();
    Machine before(database, raster_of(512, 512));
    Machine after(database, raster_of(512, 512));
    for (const double height_m : {8.0, 30.0, 120.0}) {
        for (const double border_m : {3.0, 12.0, 24.0, 48.0, 96.0, 192.0}) {
            for (const double heading_deg : {0.0, 50.0, 180.0}) {
                before.frame(packet_of(channel_at({border_m - 0.0005, 5.0, height_m}, heading_deg, -12.0)));
                after.frame(packet_of(channel_at({border_m + 0.0005, 5.0, height_m}, heading_deg, -12.0)));
                // One square or four of the same intensities differ by what interpolation on the screen, and
                // not in depth, makes of them (Appendix I): up to 4 levels in a few pixels. A pop is ten
                // times that.
                EXPECT_LE(greatest_difference(before.picture(0), after.picture(0)), 4)
                    << "height " << height_m << " border " << border_m << " heading " << heading_deg;
            }
        }
    }
}

TEST(RepeatedTile, StaysAnchoredToTheWorld) {
    // A whole period further on, the same picture; half a cell further on, another one.
    const VisualDatabase database = sea_database();
    Machine here(database, raster_of(256, 256));
    Machine there(database, raster_of(256, 256));
    const double period_m = 64 * 12.0;
    here.frame(packet_of(channel_at({100, 50, 30}, 10.0, -20.0)));
    there.frame(packet_of(channel_at({100 + 2 * period_m, 50 - period_m, 30}, 10.0, -20.0)));
    EXPECT_LE(greatest_difference(here.picture(0), there.picture(0)), 1);
    there.frame(packet_of(channel_at({106, 50, 30}, 10.0, -20.0)));
    EXPECT_GT(greatest_difference(here.picture(0), there.picture(0)), 5);
}

TEST(RepeatedTile, DoesNotSparkleFarAway) {
    // Over the last lines before the horizon the picture is one flat colour, from any height.
    const VisualDatabase database = sea_database();
    Machine machine(database, raster_of(512, 512));
    for (const double height_m : {2.0, 30.0, 400.0}) {
        machine.frame(packet_of(channel_at({0, 0, height_m}, 123.0)));
        const VideoFrame& picture = machine.picture(0);
        for (std::size_t row = 256; row < 262; ++row) {
            for (std::size_t column = 1; column < 512; ++column) {
                ASSERT_EQ(picture.pixels[row * 512 + column], picture.pixels[256 * 512]) << "row " << row;
            }
        }
    }
}

TEST(RepeatedTile, TakesTheHostsVertexNormals) {
    // Turning every normal by an angle is turning the sun by it the other way: the report's two methods agree.
    const VisualDatabase database = sea_database();
    Machine by_sun(database, raster_of(256, 256));
    Machine by_normals(database, raster_of(256, 256));
    const double turn_rad = 1.1;
    by_sun.frame(packet_of(channel_at({0, 0, 30}, 20.0, -20.0), 0.4 - turn_rad));
    FramePacket packet = packet_of(channel_at({0, 0, 30}, 20.0, -20.0), 0.4);
    VertexNormalUpdate update;
    const SineCosine turn = sine_cosine(turn_rad);
    for (std::size_t k = 0; k < 64 * 64; ++k) {
        const Vec3d n(database.tile_normals[k]);
        update.normals.push_back(
            Vec3f(Vec3d(n.x * turn.cosine - n.y * turn.sine, n.x * turn.sine + n.y * turn.cosine, n.z)));
    }
    packet.normal_updates = {update};
    ASSERT_TRUE(by_normals.frame(packet).errors.empty());
    EXPECT_LE(greatest_difference(by_sun.picture(0), by_normals.picture(0)), 1);
    packet.normal_updates[0].first = 1; // one too many
    const FrameReport& report = by_normals.frame(packet);
    ASSERT_EQ(report.errors.size(), 1U);
    EXPECT_EQ(report.errors[0], "normal_updates[0] ends at normal 4097; expected at most 4096");
}

/// The sea with the pattern of a wave of two squares, and the coarser tables in which nothing is left of it.
VisualDatabase short_wave_database(bool face_shaded) {
    VisualDatabase database = sea_database();
    RepeatedTile& tile = database.tiles[0];
    const std::uint64_t size = with_coarser_size(tile.period);
    tile.first_normal = 0;
    tile.first_face_normal = face_shaded ? 0 : static_cast<std::uint32_t>(size);
    database.tile_normals.clear();
    for (std::uint64_t k = 0; k < 2 * size; ++k) {
        const bool finest = k % size < std::uint64_t{tile.period} * tile.period;
        const float slope = !finest ? 0.0F : k % size % 2 == 0 ? 0.6F : -0.6F;
        database.tile_normals.emplace_back(slope, 0.0F, 0.8F);
    }
    return database;
}

TEST(RepeatedTile, WavesThatCoarseSquaresCannotCarryDoNotFlash) {
    for (const bool face_shaded : {false, true}) {
        const VisualDatabase database = short_wave_database(face_shaded);
        Machine machine(database, raster_of(256, 256));
        Machine other(database, raster_of(256, 256));
        // Every 2^k-th vertex alone would be bright under one sun and dark under the other.
        machine.frame(packet_of(channel_at({0, 0, 200}, 30.0, -12.0), 0.0));
        other.frame(packet_of(channel_at({0, 0, 200}, 30.0, -12.0), pi));
        const auto sum = [](const VideoFrame& picture, std::size_t first_row, std::size_t end_row) {
            double green = 0;
            for (std::size_t k = first_row * 256; k < end_row * 256; ++k)
                green += picture.pixels[k] >> 8U & 0xffU;
            return green / static_cast<double>((end_row - first_row) * 256);
        };
        EXPECT_NEAR(sum(machine.picture(0), 100, 150), sum(other.picture(0), 100, 150), 0.5);
        machine.frame(packet_of(channel_at({0, 0, 20}, 30.0, -60.0), 0.0));
        other.frame(packet_of(channel_at({0, 0, 20}, 30.0, -60.0), pi));
        EXPECT_GT(greatest_difference(machine.picture(0), other.picture(0)), 15) << "close by it is there";
    }
}

TEST(RepeatedTile, ContrastGoesWithTheSun) {
    // A sun in the zenith lights every normal of one vertical angle alike: sea state 0 (report, Figure 4).
    const VisualDatabase database = sea_database();
    Machine machine(database, raster_of(256, 256));
    FramePacket packet = packet_of(channel_at({0, 0, 30}, 0.0, -45.0));
    packet.suns = {Vec3f(0, 0, 1)};
    machine.frame(packet);
    const auto& flat = machine.picture(0).pixels;
    EXPECT_TRUE(std::all_of(flat.begin(), flat.end(), [&](std::uint32_t pixel) { return pixel == flat[0]; }));
    packet.suns = {Vec3f(direction(0.0, radians(30.0)))};
    machine.frame(packet);
    const auto& rough = machine.picture(0).pixels;
    const auto green = [](std::uint32_t a, std::uint32_t b) { return (a >> 8U & 0xffU) < (b >> 8U & 0xffU); };
    const auto [darkest, brightest] = std::minmax_element(rough.begin(), rough.end(), green);
    EXPECT_GT(static_cast<int>(*brightest >> 8U & 0xffU) - static_cast<int>(*darkest >> 8U & 0xffU), 30);
}

} // namespace
} // namespace linkdig::ig
