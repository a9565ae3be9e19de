/// The second opinions on what geometry really delivers: clipped, snapped, far and close faces of whole
/// scenes.

#include "tests/ig/random_scene.h"
#include "tests/ig/random_scene_stages.h"
#include "tests/ig/shipped_flight.h"
#include "tests/ig/small_database.h"
#include "tests/support/painter.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace linkdig::ig {
namespace {

/// What geometry makes of a packet's first channel.
Scene scene_of(const VisualDatabase& database, const FramePacket& packet, const Raster& raster) {
    return project_packet(database, packet, raster).scene;
}

/// The bounds of ig/geometry/projected_face.h, and corners that run the right way round.
void expect_contract(const ProjectedFaces& projected) {
    for (const RasterPoint& point : projected.points) {
        ASSERT_LE(std::abs(point.line), greatest_coordinate);
        ASSERT_LE(std::abs(point.element), greatest_coordinate);
    }
    for (const ProjectedFace& face : projected.faces) {
        ASSERT_GE(face.point_count, 3);
        ASSERT_GT(doubled_area(std::span(projected.points).subspan(face.first_point, face.point_count)), 0);
        ASSERT_GE(face.intensity, 0);
        ASSERT_LE(face.intensity, intensity_one);
    }
}

TEST(PainterAgainstGeometry, sea_from_all_attitudes) {
    const VisualDatabase database = sea_database();
    RandomStream random(11);
    std::size_t faces = 0;
    for (int i = 0; i < 1500; ++i) { // a gap or a doubled pixel at the near plane shows in one view of 250
        SCOPED_TRACE("view " + std::to_string(i));
        FramePacket packet;
        const double height = i % 3 == 0 ? random.between(0.3, 3.0) : random.between(3.0, 300.0);
        const Vec3d eye(random.between(-1e4, 1e4), random.between(-1e4, 1e4), height);
        packet.channels = {channel_at(eye, random.between(0.0, 360.0), random.between(-90.0, 20.0),
                                      random.between(-180.0, 180.0))};
        packet.suns = {Vec3f(direction(random.between(0.0, two_pi), 0.6))};
        const Scene scene =
            scene_of(database, packet, {160, 120, i % 2 == 0 ? Scan::horizontal : Scan::vertical});
        faces += scene.projected.faces.size();
        expect_contract(scene.projected);
        if (i < 12) expect_agreement(scene);
        // Squares, rings and the horizon are one mesh: whoever turns over the sea sees no pixel of it twice.
        const std::vector<std::uint32_t> count = support::coverage(scene.projected, scene.raster);
        EXPECT_EQ(*std::max_element(count.begin(), count.end()), 1U);
    }
    EXPECT_GT(faces, 5000U);
}

/// A static quarter of the ground: one corner at `corner_m`, two sides that run to infinity along +x +y and +x -y.
VisualDatabase wedge_of_ground(const Vec3d& corner_m) {
    VisualDatabase database;
    database.colours = {{20, 90, 40, 0}};
    database.suns = {"sun"};
    database.groups.push_back({.number = 100, .root = none});
    add_box(database, {});
    database.vertices = {{.position = Vec4f(Vec3f(corner_m), 1.0F), .normal = {0, 0, 1}},
                         {.position = {1, -1, 0, 0}, .normal = {0, 0, 1}},
                         {.position = {1, 1, 0, 0}, .normal = {0, 0, 1}}};
    database.corners = {0, 1, 2};
    database.faces.resize(1);
    database.faces[0].corner_count = 3;
    database.faces[0].normal = {0, 0, 1};
    database.runs[0].face_count = 1;
    database.runs[0].radius = -1.0F; // never out of sight
    return database;
}

TEST(PainterAgainstGeometry, ground_to_infinity_reaches_the_feet) {
    for (const double away_m : {100.0, 2000.0, 50'000.0}) {
        const VisualDatabase database = wedge_of_ground({-away_m, 0.0, 0.0});
        for (const double height_m : {0.3, 1.7, 30.0}) {
            SCOPED_TRACE(std::to_string(height_m) + " m above, corner " + std::to_string(away_m) +
                         " m behind");
            FramePacket packet;
            packet.channels = {channel_at({0, 0, height_m}, 0.0, -75.0)};
            packet.suns = {Vec3f(0, 0, 1)};
            const Scene scene = scene_of(database, packet, {160, 120, Scan::horizontal});
            expect_contract(scene.projected);
            // 75 degrees down with 60 degrees of view: every ray meets the ground, 45 degrees before the feet and beyond.
            const std::vector<std::uint32_t> count = support::coverage(scene.projected, scene.raster);
            EXPECT_EQ(*std::min_element(count.begin(), count.end()), 1U);
            EXPECT_EQ(*std::max_element(count.begin(), count.end()), 1U);
        }
    }
}

TEST(PainterAgainstGeometry, the_sea_has_no_gap) {
    const VisualDatabase database = sea_database();
    RandomStream random(12);
    for (int i = 0; i < 12; ++i) {
        SCOPED_TRACE("view " + std::to_string(i));
        FramePacket packet;
        const Vec3d eye(random.between(-1e4, 1e4), random.between(-1e4, 1e4), random.between(0.5, 500.0));
        // The channel sees 30 degrees up and down (42 to its corners): from 43 down there is nothing but sea.
        packet.channels = {channel_at(eye, random.between(0.0, 360.0), random.between(-90.0, -43.0),
                                      random.between(-180.0, 180.0))};
        packet.suns = {Vec3f(direction(0.0, 0.6))};
        const Scene scene =
            scene_of(database, packet, {160, 160, i % 2 == 0 ? Scan::horizontal : Scan::vertical});
        EXPECT_EQ(support::coverage(scene.projected, scene.raster), std::vector<std::uint32_t>(160 * 160, 1));
    }
}

TEST(PainterAgainstGeometry, the_shipped_flight) {
    const ShippedFlight flight = shipped_flight("first_flight/approach.toml", 30.0, {0, 250, 450, 599});
    ASSERT_EQ(flight.packets.size(), 4U);
    for (const FramePacket& packet : flight.packets) {
        SCOPED_TRACE("frame " + std::to_string(packet.frame));
        const Scan scan = packet.frame == 250 ? Scan::vertical : Scan::horizontal;
        const Scene scene = scene_of(flight.database, packet, {320, 240, scan});
        expect_contract(scene.projected);
        expect_agreement(scene);
    }
}

} // namespace
} // namespace linkdig::ig
