// Degenerate input on every path that draws: smoothed or not, either scan, in air, with colours of vertices; places far
// from the origin; faces of many corners; values that are no numbers.

#include "database/model/mathematics.h"
#include "ig/geometry/projected_face.h"
#include "ig/machine/machine.h"
#include "tests/ig/small_database.h"
#include "tests/support/picture_comparison.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace linkdig::ig {
namespace {

constexpr std::uint32_t side = 96;

struct Corner {
    Vec3f position;
    float intensity = 1;
};
using Polygon = std::vector<Corner>;

/// Vertex-shaded two-sided faces of one list at `origin_m` under a sun in the zenith: a normal (sin q, 0, cos q) has the
/// intensity cos q. Made by hand: the compiler would refuse most of these.
VisualDatabase database_of(const std::vector<Polygon>& faces, const Vec3d& origin_m = Vec3d(0),
                           bool coloured = false) {
    VisualDatabase database = sea_database();
    database.tiles.clear();
    ObjectList& list = database.lists[0];
    list.tile = none;
    list.root = leaf_reference(0);
    list.ambient = 0.0F;
    list.diffuse = 1.0F;
    list.origin_m = origin_m;
    database.run_leaves.push_back({.first_run = 0, .run_count = 1});
    FaceRun run;
    run.face_count = static_cast<std::uint32_t>(faces.size());
    run.radius = -1.0F;
    database.runs.push_back(run);
    for (const Polygon& corners : faces) {
        Face face;
        face.first_corner = static_cast<std::uint32_t>(database.corners.size());
        face.corner_count = static_cast<std::uint16_t>(corners.size());
        face.shading = Shading::vertex;
        face.two_sided = 1;
        face.coloured = coloured ? 1 : 0;
        for (const Corner& corner : corners) {
            database.corners.push_back(static_cast<std::uint32_t>(database.vertices.size()));
            const float rest = std::sqrt(1.0F - corner.intensity * corner.intensity);
            database.vertices.push_back({Vec4f(corner.position, 1.0F), {rest, 0, corner.intensity}});
            if (coloured) database.corner_colours.push_back({20, 90, 120, 0});
        }
        database.faces.push_back(face);
    }
    return database;
}

struct Look {
    bool smoothing = false;
    Scan scan = Scan::horizontal;
    float visibility_m = 0;
};

std::vector<Look> looks() {
    std::vector<Look> all;
    for (const bool smoothing : {false, true})
        for (const Scan scan : {Scan::horizontal, Scan::vertical})
            for (const float visibility : {0.0F, 500.0F})
                all.push_back({smoothing, scan, visibility});
    return all;
}

VideoFrame picture_of(const VisualDatabase& database, const ChannelView& channel, const Look& look = {}) {
    Configuration configuration;
    configuration.raster = {side, side, look.scan};
    configuration.edge_smoothing = look.smoothing;
    configuration.threads = 1;
    Machine machine(database, configuration);
    machine.draw_planes(true, true);
    FramePacket packet;
    packet.suns = {{0, 0, 1}};
    packet.channels = {channel};
    packet.visibility_m = look.visibility_m;
    EXPECT_TRUE(machine.frame(packet).errors.empty());
    return machine.picture(0);
}

TEST(Degenerate, FacesWithoutAPictureLeaveTheBackground) {
    const std::vector<std::vector<Polygon>> scenes = {
        {{{{-5, 1, 0}}, {{-5, -1, 0}}, {{-5, 0, 1}}}},                                    // behind the eye
        {{{{5, 0, 0}}, {{5, 0, 0}}, {{5, 0, 0}}}},                                        // a point
        {{{{5, 1, 1}, 0.1F}, {{5, 0, 0.5F}, 0.5F}, {{5, -1, 0}, 0.9F}}},                  // a line
        {{{{5, 1, 0}, 0.2F}, {{9, 1, 0}, 0.8F}, {{9, -1, 0}, 0.3F}, {{5, -1, 0}, 0.9F}}}, // edge-on
        {{{{0, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}}},                                        // through the eye
        {{{{-5, 1, 0}, 0.3F}, {{5, 1, 0}, 0.4F}, {{5, -1, 0}, 0.5F}}}, // edge-on and across the near plane
        {{{{0.1F, 1, 1}}, {{0.1F, -1, 1}}, {{0.1F, 0, -1}}}},          // before the near plane
    };
    for (const bool coloured : {false, true})
        for (const auto& scene : scenes)
            for (const Look& look : looks()) {
                const VideoFrame picture =
                    picture_of(database_of(scene, Vec3d(0), coloured), channel_at({0, 0, 0}), look);
                EXPECT_EQ(std::count(picture.rank.begin(), picture.rank.end(), none), side * side);
            }
}

/// A hexagon of six intensities is the four triangles that fan out from its first corner (report, Figure 11).
TEST(Degenerate, FacesOfManyCornersAreCutAsFigure11) {
    Polygon hexagon;
    const float intensities[6] = {0.9F, 0.1F, 0.7F, 0.2F, 1.0F, 0.4F};
    for (int k = 0; k < 6; ++k) {
        const SineCosine at = sine_cosine(-two_pi * k / 6.0 + 0.3);
        hexagon.push_back({{10.0F, static_cast<float>(4.0 * at.cosine), static_cast<float>(4.0 * at.sine)},
                           intensities[k]});
    }
    std::vector<Polygon> fan;
    for (std::size_t k = 1; k + 1 < 6; ++k)
        fan.push_back({hexagon[0], hexagon[k], hexagon[k + 1]});
    for (const Look& look : looks()) {
        const VideoFrame whole = picture_of(database_of({hexagon}), channel_at({0, 0, 0}), look);
        const VideoFrame parts = picture_of(database_of(fan), channel_at({0, 0, 0}), look);
        EXPECT_EQ(whole.pixels, parts.pixels);
        EXPECT_EQ(whole.intensity, parts.intensity);
    }
}

/// A wall whose corners lie far beyond the guard band shows the intensities of its unclipped self: those on a smaller wall
/// cut out of it, whose corners have what the large one has there.
TEST(Degenerate, IntensityOfAFaceClippedToTheGuardBandIsTheUnclippedOnes) {
    const auto wall = [](float reach) { // intensity 0.5 in the middle, changing by 0.4 over 50 km
        const auto at = [](float y, float z) { return 0.5F + 0.4F * (y + z) / 100000.0F; };
        return std::vector<Polygon>{{{{10, reach, -reach}, at(reach, -reach)},
                                     {{10, -reach, -reach}, at(-reach, -reach)},
                                     {{10, -reach, reach}, at(-reach, reach)},
                                     {{10, reach, reach}, at(reach, reach)}}};
    };
    ChannelView view = channel_at({0, 0, 0});
    view.left_tangent = view.bottom_tangent = -1;
    view.right_tangent = view.top_tangent = 1;
    for (const Look& look : looks()) {
        const VideoFrame large = picture_of(database_of(wall(50000)), view, look);
        const VideoFrame small = picture_of(database_of(wall(20)), view, look);
        ASSERT_EQ(std::count(large.rank.begin(), large.rank.end(), none), 0);
        EXPECT_LE(support::compare(small, large).worst_level, 1U);
    }
}

/// 10,000 km from the origin the picture is the one at the origin: places are taken relative to the eye, in double.
TEST(Degenerate, AWorldFarFromItsOriginLooksTheSame) {
    const std::vector<Polygon> faces = {
        {{{10, 4, -3}, 0.9F}, {{12, -4, -3}, 0.1F}, {{11, 0, 5}, 0.5F}},
        {{{-30, 40, -4}, 0.2F}, {{-30, -40, -4}, 0.3F}, {{90, -40, -4}, 1}, {{90, 40, -4}, 0.6F}}};
    for (const Vec3d& far : {Vec3d(1e7 - 128, -1e7 + 128, 512), Vec3d(-1e7 + 64, 1e7 - 64, -1e6)})
        for (const Look& look : looks()) {
            const VideoFrame near_by = picture_of(database_of(faces), channel_at({0, 0, 0}, 10, -5, 3), look);
            const VideoFrame far_off = picture_of(database_of(faces, far), channel_at(far, 10, -5, 3), look);
            EXPECT_EQ(near_by.pixels, far_off.pixels);
        }
}

TEST(Degenerate, GroundAsWideAsCoordinatesGoReachesTheHorizon) {
    const float reach = 1e7F;
    const std::vector<Polygon> faces = {{{{reach, reach, 0}, 0.8F},
                                         {{-reach, reach, 0}, 0.8F},
                                         {{-reach, -reach, 0}, 0.2F},
                                         {{reach, -reach, 0}, 0.2F}}};
    for (const Look& look : looks()) {
        const VideoFrame picture = picture_of(database_of(faces), channel_at({0, 0, 2}, 30.0), look);
        for (std::size_t k = 0; k < picture.rank.size(); ++k)
            ASSERT_EQ(picture.rank[k] == none, k / side < side / 2) << "row " << k / side;
    }
}

/// Whatever number of a packet is none, or endless, the packet is refused by the field's name, and the picture stays.
TEST(Degenerate, NumbersThatAreNoneAreRefusedByName) {
    const VisualDatabase database = database_of({{{{10, 4, -3}}, {{12, -4, -3}}, {{11, 0, 5}}}});
    Configuration configuration;
    configuration.raster = {side, side, Scan::horizontal};
    Machine machine(database, configuration);
    FramePacket good;
    good.suns = {{0, 0, 1}};
    good.channels = {channel_at({0, 0, 0})};
    good.lighting = {{.list = 0, .sun = 0, .ambient = 0, .diffuse = 1}};
    ASSERT_TRUE(machine.frame(good).errors.empty());
    const std::vector<std::uint32_t> before = machine.picture(0).pixels;
    struct Field {
        const char* name;
        std::function<void(FramePacket&, double)> set;
    };
    const auto narrow = [](double value) { return static_cast<float>(value); };
    const std::vector<Field> fields = {
        {"time_s", [](FramePacket& p, double v) { p.time_s = v; }},
        {"channels[0].eye_m", [](FramePacket& p, double v) { p.channels[0].eye_m.y = v; }},
        {"attitude.heading_rad", [](FramePacket& p, double v) { p.channels[0].attitude.heading_rad = v; }},
        {"attitude.pitch_rad", [](FramePacket& p, double v) { p.channels[0].attitude.pitch_rad = v; }},
        {"attitude.roll_rad", [](FramePacket& p, double v) { p.channels[0].attitude.roll_rad = v; }},
        {"left_tangent", [](FramePacket& p, double v) { p.channels[0].left_tangent = v; }},
        {"top_tangent", [](FramePacket& p, double v) { p.channels[0].top_tangent = v; }},
        {"suns[0]", [&](FramePacket& p, double v) { p.suns[0].x = narrow(v); }},
        {"lighting[0].ambient", [&](FramePacket& p, double v) { p.lighting[0].ambient = narrow(v); }},
        {"lighting[0].diffuse", [&](FramePacket& p, double v) { p.lighting[0].diffuse = narrow(v); }},
        {"lod_bias", [&](FramePacket& p, double v) { p.lod_bias = narrow(v); }},
        {"visibility_m", [&](FramePacket& p, double v) { p.visibility_m = narrow(v); }},
        {"sky", [&](FramePacket& p, double v) { p.sky.z = narrow(v); }},
        {"time_of_day_h", [&](FramePacket& p, double v) { p.time_of_day_h = narrow(v); }},
        {"sea.state", [&](FramePacket& p, double v) { p.sea.state = narrow(v); }},
    };
    for (const Field& field : fields)
        for (const double value :
             {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
              -std::numeric_limits<double>::infinity()}) {
            FramePacket packet = good;
            field.set(packet, value);
            const FrameReport& report = machine.frame(packet);
            ASSERT_EQ(report.errors.size(), 1U) << field.name;
            EXPECT_NE(report.errors[0].find(field.name), std::string::npos) << report.errors[0];
            EXPECT_EQ(machine.picture(0).pixels, before);
        }
}

} // namespace
} // namespace linkdig::ig
