// Limited visibility against the exact value, pixel by pixel.

#include "tests/ig/small_database.h"

#include "database/model/mathematics.h"
#include "ig/geometry/projected_face.h"
#include "ig/machine/machine.h"
#include "ig/simd/simd_level.h"
#include "ig/video/pixel_run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace linkdig::ig {
namespace {

constexpr std::uint32_t side = 200;

Configuration raster_of(Scan scan) {
    Configuration configuration;
    configuration.raster = {side, side, scan};
    configuration.threads = 1;
    return configuration;
}

Vec3d ray(const ChannelView& channel, std::uint32_t row, std::uint32_t column) {
    const Mat3d body = world_from_body(channel.attitude);
    const double x =
        channel.left_tangent + (channel.right_tangent - channel.left_tangent) * (column + 0.5) / side;
    const double y =
        channel.top_tangent - (channel.top_tangent - channel.bottom_tangent) * (row + 0.5) / side;
    return body[0] - x * body[1] + y * body[2];
}

FramePacket packet_of(const ChannelView& channel, float visibility_m) {
    FramePacket packet;
    packet.channels = {channel};
    packet.suns = {Vec3f(direction(0.4, radians(30.0)))};
    packet.sky = {0.9F, 0.8F, 0.7F};
    packet.visibility_m = visibility_m;
    return packet;
}

/// The largest difference of a component from code x intensity x t + horizon x (1 - t), over all pixels of the plane
/// z = 0, in levels. Intensities are the machine's own; range and extinction are the libraries' exact ones.
double worst_error(const VisualDatabase& database, Scan scan, const FramePacket& packet) {
    Machine machine(database, raster_of(scan));
    machine.draw_planes(true, true);
    EXPECT_TRUE(machine.frame(packet).errors.empty());
    const VideoFrame& picture = machine.picture(0);
    const ChannelView& channel = packet.channels[0];
    const double horizon[3] = {std::round(0.9F * 255.0), std::round(0.8F * 255.0), std::round(0.7F * 255.0)};
    double worst = 0.0;
    for (std::uint32_t k = 0; k < side * side; ++k) {
        if (picture.rank[k] < 0) continue;
        const Vec3d along = ray(channel, k / side, k % side);
        // At the plane's horizon the snapped edge of a face may stand half a pixel too high: there it is infinitely far.
        const double range = along.z < 0.0 ? channel.eye_m.z / -along.z * glm::length(along) : 1e30;
        const double t = std::exp(-2.996 * range / static_cast<double>(packet.visibility_m));
        const Colour colour = database.colours[machine.source(0, picture.rank[k]).face->colour];
        const double codes[3] = {static_cast<double>(colour.red), static_cast<double>(colour.green),
                                 static_cast<double>(colour.blue)};
        const double intensity = picture.intensity[k] / static_cast<double>(intensity_one);
        for (int c = 0; c < 3; ++c) {
            const double exact = codes[c] * intensity * t + horizon[c] * (1.0 - t);
            worst =
                std::max(worst, std::fabs(exact - static_cast<double>(picture.pixels[k] >> (8 * c) & 0xffU)));
        }
    }
    return worst;
}

TEST(Visibility, SeaIsWithinTwoLevelsOfTheExactValueToTheHorizon) {
    const VisualDatabase database = sea_database();
    for (const Scan scan : {Scan::horizontal, Scan::vertical}) {
        for (const float visibility_m : {100.0F, 1500.0F, 20000.0F, 100000.0F}) {
            for (const double height_m : {3.0, 30.0, 900.0}) {
                for (const double roll_deg : {0.0, 35.0}) {
                    const ChannelView view = channel_at({17, -5, height_m}, 20.0, -12.0, roll_deg);
                    EXPECT_LE(worst_error(database, scan, packet_of(view, visibility_m)), 2.0)
                        << "visibility " << visibility_m << " height " << height_m << " roll " << roll_deg;
                }
            }
        }
    }
}

TEST(Visibility, ClearAirLeavesThePictureAsItIs) {
    const VisualDatabase database = sea_database();
    Machine machine(database, raster_of(Scan::horizontal));
    machine.frame(packet_of(channel_at({0, 0, 30}, 0, -10), 0.0F));
    const std::vector<std::uint32_t> clear = machine.picture(0).pixels;
    machine.frame(packet_of(channel_at({0, 0, 30}, 0, -10), 500.0F));
    EXPECT_NE(machine.picture(0).pixels, clear);
    machine.frame(packet_of(channel_at({0, 0, 30}, 0, -10), 1e12F));
    std::size_t off = 0;
    for (std::size_t k = 0; k < clear.size(); ++k) {
        for (int shift = 0; shift < 24; shift += 8) {
            const int a = static_cast<int>(clear[k] >> shift & 0xffU);
            const int b = static_cast<int>(machine.picture(0).pixels[k] >> shift & 0xffU);
            if (std::abs(a - b) > 1) ++off;
        }
    }
    EXPECT_EQ(off, 0U);
}

TEST(Visibility, ChannelSeamsMeet) {
    // The last column of one channel and the first of the next look almost the same way: so must the air.
    const VisualDatabase database = sea_database();
    Machine machine(database, raster_of(Scan::horizontal));
    FramePacket packet = packet_of(channel_at({0, 0, 25}, 0.0, 0.0), 3000.0F);
    packet.channels.push_back(packet.channels[0]);
    packet.channels[0].left_tangent = -1.0;
    packet.channels[0].right_tangent = 0.0;
    packet.channels[1].left_tangent = 0.0;
    packet.channels[1].right_tangent = 1.0;
    machine.frame(packet);
    for (std::uint32_t row = 0; row < side; ++row) {
        const std::uint32_t a = machine.picture(0).pixels[row * side + side - 1];
        const std::uint32_t b = machine.picture(1).pixels[row * side];
        for (int shift = 0; shift < 24; shift += 8) {
            EXPECT_NEAR(static_cast<int>(a >> shift & 0xffU), static_cast<int>(b >> shift & 0xffU), 3) << row;
        }
    }
}

TEST(Visibility, EveryLevelGivesTheSameBytes) {
    const VisualDatabase database = sea_database();
    std::vector<std::uint32_t> expected;
    for (const std::string& level : simd_levels()) {
        ASSERT_TRUE(use_simd_level(level));
        Machine machine(database, raster_of(Scan::horizontal));
        machine.frame(packet_of(channel_at({0, 0, 30}, 0, -10, 12), 2500.0F));
        if (expected.empty()) expected = machine.picture(0).pixels;
        EXPECT_EQ(machine.picture(0).pixels, expected) << level;
    }
    use_simd_level("best");
}

} // namespace
} // namespace linkdig::ig
