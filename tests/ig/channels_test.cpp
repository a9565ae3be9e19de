// Channels: what leaves one picture's border enters the next one's.

#include "tests/ig/small_database.h"

#include "database/model/mathematics.h"
#include "ig/geometry/projected_face.h"
#include "ig/machine/machine.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace linkdig::ig {
namespace {

VisualDatabase scene() {
    VisualDatabase database = sea_database();
    database.groups.insert(database.groups.begin(), {.number = 1, .root = none});
    database.clusters[0].group = 1;
    database.moving_objects = {"ship"};
    add_box(database, {.from = {-60, -9, 0}, .to = {60, 9, 14}, .colour = 1, .group = 0, .moving_object = 0});
    return database;
}

FramePacket packet_of(std::vector<ChannelView> channels) {
    FramePacket packet;
    packet.suns = {Vec3f(direction(0.4, radians(30.0)))};
    packet.channels = std::move(channels);
    packet.moving_objects.resize(1);
    packet.moving_objects[0].position_m = {150, 0, 0};
    packet.moving_objects[0].attitude.heading_rad = 1.2;
    return packet;
}

TEST(Channels, HalvesOfAPictureAreThePicture) {
    const VisualDatabase database = scene();
    for (const Scan scan : {Scan::horizontal, Scan::vertical}) {
        Configuration wide;
        wide.raster = {400, 200, scan};
        Configuration half = wide;
        half.raster.width = 200;
        ChannelView view = channel_at({0, 0, 20}, 3.0, -5.0, 7.0);
        view.left_tangent = -1.0;
        view.right_tangent = 1.0;
        Machine whole(database, wide);
        whole.draw_planes(true, true);
        whole.frame(packet_of({view}));
        Machine halves(database, half);
        halves.draw_planes(true, true);
        std::vector<ChannelView> views = {view, view};
        views[0].right_tangent = views[1].left_tangent = 0.0;
        halves.frame(packet_of(views));
        int other_face = 0;
        for (std::size_t row = 0; row < 200; ++row) {
            for (std::size_t column = 0; column < 400; ++column) {
                const std::size_t channel = column / 200;
                const std::size_t at = row * 200 + column % 200;
                const auto seen = [](const Machine& machine, std::size_t c, std::int32_t rank) {
                    return rank < 0 ? nullptr : machine.source(c, rank).face;
                };
                const Face* expected = seen(whole, 0, whole.picture(0).rank[row * 400 + column]);
                const Face* shown = seen(halves, channel, halves.picture(channel).rank[at]);
                // Faces made this frame (the sea) stand elsewhere in each machine's pools: compare what they are.
                const bool same = (expected == nullptr) == (shown == nullptr) &&
                                  (expected == nullptr || expected->object == shown->object);
                if (!same) ++other_face;
                EXPECT_NEAR(halves.picture(channel).intensity[at],
                            whole.picture(0).intensity[row * 400 + column], 2.0 * intensity_one / 255.0)
                    << row << " " << column;
            }
        }
        EXPECT_EQ(other_face, 0);
    }
}

/// Greatest difference of a component.
int apart(std::uint32_t a, std::uint32_t b) {
    int most = 0;
    for (const std::uint32_t shift : {0U, 8U, 16U})
        most = std::max(
            most, std::abs(static_cast<int>(a >> shift & 0xffU) - static_cast<int>(b >> shift & 0xffU)));
    return most;
}

TEST(Channels, HalvesOfAPictureInHazeAreThePicture) {
    VisualDatabase database = scene();
    for (const Scan scan : {Scan::horizontal, Scan::vertical}) {
        Configuration wide;
        wide.raster = {400, 200, scan};
        Configuration half = wide;
        half.raster.width = 200;
        ChannelView view = channel_at({0, 0, 20}, 3.0, -5.0, 7.0);
        view.left_tangent = -1.0;
        view.right_tangent = 1.0;
        std::vector<ChannelView> views = {view, view};
        views[0].right_tangent = views[1].left_tangent = 0.0;
        Machine whole(database, wide);
        Machine halves(database, half);
        FramePacket one = packet_of({view});
        FramePacket two = packet_of(views);
        one.visibility_m = two.visibility_m = 600.0F;
        one.sky = two.sky = {0.9F, 0.8F, 0.7F};
        whole.frame(one);
        halves.frame(two);
        for (std::size_t row = 0; row < 200; ++row)
            for (std::size_t column = 0; column < 400; ++column)
                EXPECT_LE(apart(whole.picture(0).pixels[row * 400 + column],
                                halves.picture(column / 200).pixels[row * 200 + column % 200]),
                          2)
                    << row << " " << column;
    }
}

TEST(Channels, HazeCrossesTheSeamOfTurnedChannels) {
    // The seam's columns are mirror images: on level ground of one colour both see the same ranges.
    VisualDatabase database = scene();
    database.lists[0].tile = none;
    add_box(database, {.from = {-5000, -5000, -1}, .to = {5000, 5000, 0}, .colour = 1, .group = 0});
    Configuration configuration;
    configuration.raster = {480, 360, Scan::vertical};
    Machine machine(database, configuration);
    const double half_width = tangent(radians(24.0));
    std::vector<ChannelView> views = {channel_at({0, 0, 20}, 24.0), channel_at({0, 0, 20}, -24.0)};
    for (ChannelView& view : views) {
        view.left_tangent = -half_width;
        view.right_tangent = half_width;
        view.bottom_tangent = -0.75 * half_width;
        view.top_tangent = 0.75 * half_width;
    }
    FramePacket packet = packet_of(views);
    packet.moving_objects[0].visible = false;
    packet.visibility_m = 500.0F;
    ASSERT_TRUE(machine.frame(packet).errors.empty());
    int shades = 0;
    for (std::size_t row = 0; row < 360; ++row) {
        const std::uint32_t left = machine.picture(0).pixels[row * 480 + 479];
        const std::uint32_t right = machine.picture(1).pixels[row * 480];
        EXPECT_LE(apart(left, right), 1) << row;
        if (row > 0) shades += left != machine.picture(0).pixels[(row - 1) * 480 + 479] ? 1 : 0;
    }
    EXPECT_GT(shades, 50) << "the haze is there";
}

/// Row at which the box's upper edge, the sky behind it, crosses a column, to a fraction of a pixel: smoothed edges keep it.
double edge_row(const VideoFrame& picture, std::uint32_t column) {
    double sky = 0.0;
    for (std::uint32_t row = 0; row < picture.height; ++row) {
        const std::uint32_t pixel = picture.pixels[row * picture.width + column];
        sky += (pixel >> 16U & 0xffU) / 255.0; // the sky alone is blue
    }
    return sky;
}

TEST(Channels, AnEdgeCrossesTheSeamOfTurnedChannelsWithoutAStep) {
    // Two channels side by side, turned by 48 degrees, the frusta meeting in one plane.
    VisualDatabase database = scene();
    database.lists[0].tile = none;
    database.colours[1] = {255, 0, 0, 0};
    Configuration configuration;
    configuration.raster = {480, 360, Scan::vertical};
    configuration.edge_smoothing = true;
    Machine machine(database, configuration);
    const double half_width = tangent(radians(24.0));
    std::vector<ChannelView> views = {channel_at({0, 0, 20}, 24.0), channel_at({0, 0, 20}, -24.0)};
    for (ChannelView& view : views) {
        view.left_tangent = -half_width;
        view.right_tangent = half_width;
        view.bottom_tangent = -0.75 * half_width;
        view.top_tangent = 0.75 * half_width;
    }
    FramePacket packet = packet_of(views);
    packet.sky = {0, 0, 1};
    packet.moving_objects[0].position_m = {60, 0, -6};
    packet.moving_objects[0].attitude = {1.45, 0.0, 0.12};
    machine.frame(packet);
    // Extrapolate either side's edge to the seam from its last two columns; one column is half a pixel from it.
    const VideoFrame& left = machine.picture(0);
    const VideoFrame& right = machine.picture(1);
    const double from_left = edge_row(left, 479) + 0.5 * (edge_row(left, 479) - edge_row(left, 478));
    const double from_right = edge_row(right, 0) - 0.5 * (edge_row(right, 1) - edge_row(right, 0));
    EXPECT_GT(from_left, 20.0);
    EXPECT_LT(from_left, 340.0);
    EXPECT_NEAR(from_left, from_right, 0.05);
}

TEST(Channels, ChannelsThatAreOffStayDark) {
    const VisualDatabase database = scene();
    Configuration configuration;
    configuration.raster = {64, 64, Scan::horizontal};
    Machine machine(database, configuration);
    std::vector<ChannelView> views(8, channel_at({0, 0, 20}));
    views[3].on = false;
    ASSERT_TRUE(machine.frame(packet_of(views)).errors.empty());
    for (std::size_t c = 0; c < 8; ++c)
        EXPECT_EQ(machine.picture(c).pixels.empty(), c == 3) << c;
    views.push_back(views[0]);
    EXPECT_EQ(machine.frame(packet_of(views)).errors.size(), 1U);
}

TEST(Channels, DelaysAreThoseOfTheProfile) {
    const VisualDatabase database = scene();
    Machine ames(database, ames_profile());
    const FrameReport& report = ames.frame(packet_of({channel_at({0, 0, 20})}));
    ASSERT_EQ(report.fields.size(), 2U);
    const double line_s = 1.0 / 60.0 / 384.0; // 768 columns, half of them a field
    EXPECT_NEAR(report.fields[0].first_line_s, 4.0 / 60.0, 1e-12);
    EXPECT_NEAR(report.fields[0].last_line_s, 5.0 / 60.0 - line_s, 1e-12);
    EXPECT_NEAR(report.fields[1].first_line_s, 5.0 / 60.0, 1e-12);
    EXPECT_NEAR(report.fields[1].last_line_s, 6.0 / 60.0 - line_s, 1e-12);
    EXPECT_NEAR(mid_screen_delay_s(ames_profile()), 0.0833, 0.0001);
    Machine modern(database, modern_profile());
    const FrameReport& progressive = modern.frame(packet_of({channel_at({0, 0, 20})}));
    ASSERT_EQ(progressive.fields.size(), 1U);
    EXPECT_EQ(progressive.fields[0].first_line_s, 0.0);
    EXPECT_NEAR(progressive.fields[0].last_line_s, 1023.0 / 1024.0 / 60.0, 1e-12);
}

} // namespace
} // namespace linkdig::ig
