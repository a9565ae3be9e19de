// Geometry: clipping, the order of cutting and shading, and input that has no picture.

#include "tests/ig/small_database.h"

#include "database/model/mathematics.h"
#include "ig/geometry/projected_face.h"
#include "ig/machine/machine.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace linkdig::ig {
namespace {

/// A database of one static list with the faces given, vertex-shaded; the sun stands in the zenith, so a
/// normal (sin q, 0, cos q) has the intensity cos q.
struct Corner {
    Vec3f position;
    float intensity;
};

VisualDatabase database_of(const std::vector<std::vector<Corner>>& faces, bool two_sided = false) {
    VisualDatabase database = sea_database();
    database.tiles.clear();
    database.lists[0].tile = none;
    database.lists[0].root = leaf_reference(0);
    database.lists[0].ambient = 0.0F;
    database.lists[0].diffuse = 1.0F;
    database.run_leaves.push_back({.first_run = 0, .run_count = 1});
    FaceRun run;
    run.face_count = static_cast<std::uint32_t>(faces.size());
    run.radius = -1.0F;
    database.runs.push_back(run);
    for (const auto& corners : faces) {
        Face face;
        face.first_corner = static_cast<std::uint32_t>(database.corners.size());
        face.corner_count = static_cast<std::uint16_t>(corners.size());
        face.shading = Shading::vertex;
        face.two_sided = two_sided ? 1 : 0;
        for (const Corner& corner : corners) {
            database.corners.push_back(static_cast<std::uint32_t>(database.vertices.size()));
            const float rest = std::sqrt(1.0F - corner.intensity * corner.intensity);
            database.vertices.push_back(
                {.position = Vec4f(corner.position, 1.0F), .normal = {rest, 0, corner.intensity}});
        }
        database.faces.push_back(face);
    }
    return database;
}

Configuration raster_of(std::uint32_t width, std::uint32_t height, Scan scan = Scan::horizontal) {
    Configuration configuration;
    configuration.raster = {width, height, scan};
    configuration.threads = 1;
    return configuration;
}

FramePacket packet_of(const ChannelView& channel) {
    FramePacket packet;
    packet.suns = {{0, 0, 1}};
    packet.channels = {channel};
    return packet;
}

/// A square of ground from 10 to 60 m ahead, bright near and dark far.
std::vector<std::vector<Corner>> ground() {
    return {{{{10, 20, 0}, 0.9F}, {{10, -20, 0}, 0.9F}, {{60, -20, 0}, 0.1F}, {{60, 20, 0}, 0.1F}}};
}

TEST(Geometry, IntensityOfASideClippedFaceIsTheUnclippedOnes) {
    const VisualDatabase database = database_of(ground());
    Machine whole(database, raster_of(512, 512));
    Machine part(database, raster_of(64, 512));
    whole.draw_planes(true, false);
    part.draw_planes(true, false);
    ChannelView view = channel_at({0, 0, 8});
    view.left_tangent = view.bottom_tangent = -2.0;
    view.right_tangent = view.top_tangent = 2.0;
    whole.frame(packet_of(view));
    view.left_tangent = 0.25; // columns 288 to 352 of the whole picture
    view.right_tangent = 0.75;
    part.frame(packet_of(view));
    int compared = 0;
    for (std::size_t row = 0; row < 512; ++row) {
        for (std::size_t column = 0; column < 64; ++column) {
            const std::int32_t a = whole.picture(0).intensity[row * 512 + column + 288];
            const std::int32_t b = part.picture(0).intensity[row * 64 + column];
            ASSERT_EQ(a < 0, b < 0) << row << " " << column;
            if (a < 0) continue;
            EXPECT_NEAR(a, b, intensity_one / 255.0) << row << " " << column;
            ++compared;
        }
    }
    EXPECT_GT(compared, 1000);
}

TEST(Geometry, IntensityRunsAlongTheScreenAsAppendixI) {
    // On the centre column the intensity is linear in the row between the square's near and far side, not in
    // depth.
    const VisualDatabase database =
        database_of({{{{10, 1, 0}, 0.9F}, {{10, -1, 0}, 0.9F}, {{60, -6, 0}, 0.1F}},
                     {{{10, 1, 0}, 0.9F}, {{60, -6, 0}, 0.1F}, {{60, 6, 0}, 0.1F}}});
    Machine machine(database, raster_of(500, 500));
    machine.draw_planes(true, false);
    ChannelView view = channel_at({0, 0, 5});
    view.left_tangent = view.bottom_tangent = -1.0;
    view.right_tangent = view.top_tangent = 1.0;
    machine.frame(packet_of(view));
    const double near_row = 250.0 + 250.0 * 5.0 / 10.0;
    const double far_row = 250.0 + 250.0 * 5.0 / 60.0;
    for (std::size_t row = 275; row < 370; row += 5) {
        const double t = (static_cast<double>(row) + 0.5 - far_row) / (near_row - far_row);
        const double expected = 0.1 + t * 0.8;
        EXPECT_NEAR(machine.picture(0).intensity[row * 500 + 250] / static_cast<double>(intensity_one),
                    expected, 1.0 / 255.0)
            << row;
    }
}

TEST(Geometry, VerticalScanShowsTheSamePicture) {
    const VisualDatabase database = database_of(ground());
    Machine rows(database, raster_of(300, 200));
    Machine columns(database, raster_of(300, 200, Scan::vertical));
    const FramePacket packet = packet_of(channel_at({0, 3, 8}, 10.0, -15.0, 25.0));
    rows.frame(packet);
    columns.frame(packet);
    int different = 0;
    for (std::size_t k = 0; k < rows.picture(0).pixels.size(); ++k) {
        const int a = static_cast<int>(rows.picture(0).pixels[k] >> 8U & 0xffU);
        const int b = static_cast<int>(columns.picture(0).pixels[k] >> 8U & 0xffU);
        if (std::abs(a - b) > 1) ++different;
    }
    EXPECT_EQ(different, 0);
}

TEST(Geometry, FacesBehindTheEyeEdgeOnAndWithoutAreaHaveNoPicture) {
    const std::vector<std::vector<std::vector<Corner>>> scenes = {
        {{{{-5, 1, 0}, 1}, {{-5, -1, 0}, 1}, {{-5, 0, 1}, 1}}},              // behind
        {{{{5, 0, 0}, 1}, {{5, 0, 0}, 1}, {{5, 0, 0}, 1}}},                  // a point
        {{{{5, 1, 1}, 1}, {{5, 0, 0.5F}, 1}, {{5, -1, 0}, 1}}},              // a line
        {{{{5, 1, 0}, 1}, {{9, 1, 0}, 1}, {{9, -1, 0}, 1}, {{5, -1, 0}, 1}}} // edge-on, at eye height
    };
    for (const auto& scene : scenes) {
        const VisualDatabase database = database_of(scene, true);
        Machine machine(database, raster_of(128, 128));
        machine.draw_planes(false, true);
        ASSERT_TRUE(machine.frame(packet_of(channel_at({0, 0, 0}))).errors.empty());
        const auto& rank = machine.picture(0).rank;
        EXPECT_EQ(std::count(rank.begin(), rank.end(), none), 128 * 128);
    }
}

TEST(Geometry, OneSidedFacesAreSeenFromTheFrontAlone) {
    const std::vector<std::vector<Corner>> faces = {{{{10, 3, -3}, 1}, {{10, -3, -3}, 1}, {{10, 0, 3}, 1}}};
    for (const bool two_sided : {false, true}) {
        const VisualDatabase database = database_of(faces, two_sided);
        Machine machine(database, raster_of(64, 64));
        EXPECT_EQ(machine.frame(packet_of(channel_at({0, 0, 0}))).channels[0].faces_projected, 1U);
        EXPECT_EQ(machine.frame(packet_of(channel_at({20, 0, 0}, 180.0))).channels[0].faces_projected,
                  two_sided ? 1U : 0U);
    }
}

TEST(Geometry, AFaceAroundTheEyeFillsThePictureBelowTheHorizon) {
    // 2,000 km of ground that reaches behind the eye: near plane, guard band and subdivision at once.
    const float far = 1e6F;
    const VisualDatabase database = database_of(
        {{{{far, far, 0}, 0.8F}, {{-far, far, 0}, 0.8F}, {{-far, -far, 0}, 0.2F}, {{far, -far, 0}, 0.2F}}});
    for (const Scan scan : {Scan::horizontal, Scan::vertical}) {
        Machine machine(database, raster_of(160, 160, scan));
        machine.draw_planes(true, true);
        machine.frame(packet_of(channel_at({0, 0, 2}, 30.0)));
        const VideoFrame& picture = machine.picture(0);
        for (std::size_t k = 0; k < picture.rank.size(); ++k) {
            ASSERT_EQ(picture.rank[k] == none, k / 160 < 80) << "row " << k / 160;
            if (k / 160 < 80) continue;
            ASSERT_GE(picture.intensity[k], intensity_one / 5 - 1);
            ASSERT_LE(picture.intensity[k], 4 * (intensity_one / 5) + 2);
        }
    }
}

TEST(Geometry, AFaceOfTenThousandVerticesIsDrawnWhole) {
    std::vector<Corner> circle;
    for (int k = 0; k < 10000; ++k) {
        const SineCosine at = sine_cosine(-two_pi * k / 10000.0);
        circle.push_back(
            {{10.0F, static_cast<float>(3.0 * at.cosine), static_cast<float>(3.0 * at.sine)}, 1.0F});
    }
    const VisualDatabase database = database_of({circle});
    Machine machine(database, raster_of(400, 400));
    machine.draw_planes(false, true);
    ChannelView view = channel_at({0, 0, 0});
    view.left_tangent = view.bottom_tangent = -0.5;
    view.right_tangent = view.top_tangent = 0.5;
    machine.frame(packet_of(view));
    const auto& rank = machine.picture(0).rank;
    const auto covered =
        static_cast<double>(rank.size()) - static_cast<double>(std::count(rank.begin(), rank.end(), none));
    EXPECT_NEAR(covered, pi * 120.0 * 120.0, 0.002 * pi * 120.0 * 120.0); // radius 3 m at 10 m is 120 pixels
}

TEST(Geometry, RefusesPacketsThatCannotBeDrawnAndKeepsThePicture) {
    const VisualDatabase database = database_of(ground());
    Machine machine(database, raster_of(64, 64));
    const FramePacket good = packet_of(channel_at({0, 0, 8}, 0, -20));
    ASSERT_TRUE(machine.frame(good).errors.empty());
    const std::vector<std::uint32_t> before = machine.picture(0).pixels;
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    std::vector<FramePacket> bad(8, good);
    bad[0].channels[0].eye_m.x = nan;
    bad[1].channels[0].eye_m.z = infinity;
    bad[2].channels[0].attitude.heading_rad = nan;
    bad[3].channels[0].right_tangent = bad[3].channels[0].left_tangent;
    bad[4].suns.clear();
    bad[5].suns[0] = {0, 0, 0};
    bad[6].moving_objects.resize(1);
    bad[7].substitutions.push_back({.slot = 0, .index = 0});
    for (const FramePacket& packet : bad) {
        const FrameReport& report = machine.frame(packet);
        ASSERT_EQ(report.errors.size(), 1U);
        EXPECT_FALSE(report.errors[0].empty());
        EXPECT_EQ(machine.picture(0).pixels, before) << report.errors[0];
    }
}

TEST(Geometry, RefusesARasterOutOfBounds) {
    const VisualDatabase database = database_of(ground());
    for (const auto& [width, height] : {std::pair{0U, 64U}, {64U, 0U}, {4097U, 64U}, {64U, 4097U}}) {
        EXPECT_THROW(Machine(database, raster_of(width, height)), std::invalid_argument);
    }
    EXPECT_NO_THROW(Machine(database, raster_of(1, 1)).frame(packet_of(channel_at({0, 0, 8}))));
    EXPECT_NO_THROW(Machine(database, raster_of(4096, 3)).frame(packet_of(channel_at({0, 0, 8}))));
}

} // namespace
} // namespace linkdig::ig
