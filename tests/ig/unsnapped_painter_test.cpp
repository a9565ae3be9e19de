// Snapping to 1/256 pixel moves an edge by less than 1/128 pixel: everywhere else the machine shows what a painter without
// a raster sees.

#include "database/model/mathematics.h"
#include "tests/ig/random_scene.h"
#include "tests/ig/random_scene_stages.h"
#include "tests/ig/shipped_flight.h"
#include "tests/ig/small_database.h"
#include "tests/support/unsnapped_painter.h"

#include <gtest/gtest.h>

#include <cmath>

namespace linkdig::ig {
namespace {

constexpr double margin = 1.0 / 128.0;

/// Regular polygons of 3 to 12 corners at random places before the eye, some at the side and behind it, one- and
/// two-sided, flat and smooth.
VisualDatabase random_polygons(std::uint64_t seed, int count) {
    VisualDatabase database = sea_database();
    database.lists[0].tile = none;
    database.lists[0].root = leaf_reference(0);
    database.run_leaves.push_back({.first_run = 0, .run_count = 1});
    database.runs.push_back({.face_count = static_cast<std::uint32_t>(count), .radius = -1.0F});
    RandomStream random(seed);
    for (int i = 0; i < count; ++i) {
        const Mat3d turn = world_from_body({random.between(0, two_pi), random.between(-1.5, 1.5), 0.0});
        const Vec3d centre(random.between(-3, 60), random.between(-25, 25), random.between(-25, 25));
        const double radius = random.between(0.2, 9.0);
        const int corners = random.integer(3, 12);
        Face face;
        face.first_corner = static_cast<std::uint32_t>(database.corners.size());
        face.corner_count = static_cast<std::uint16_t>(corners);
        face.colour = static_cast<std::uint16_t>(i % 4);
        face.shading = i % 3 == 0 ? Shading::vertex : Shading::unshaded;
        face.two_sided = i % 2 == 0 ? 1 : 0;
        face.normal = Vec3f(turn[0]);
        for (int k = 0; k < corners; ++k) {
            const SineCosine angle = sine_cosine(two_pi * k / corners);
            const Vec3d p = centre + radius * (angle.cosine * turn[1] + angle.sine * turn[2]);
            database.corners.push_back(static_cast<std::uint32_t>(database.vertices.size()));
            database.vertices.push_back(
                {Vec4f(Vec3f(p), 1.0F), Vec3f(direction(random.between(0, two_pi), random.between(-1, 1)))});
        }
        database.faces.push_back(face);
    }
    return database;
}

struct Agreement {
    int compared = 0;
    int near_edges = 0;
    int faces_seen = 0;
};

/// The stages up to the scanline against the painter, on the packet's first channel.
void expect_same_faces(const VisualDatabase& database, const FramePacket& packet, const Raster& raster,
                       Agreement& agreement) {
    const auto [active, order, scene] = project_packet(database, packet, raster);
    const VideoFrame picture = draw(scene).picture;
    const auto painted = support::paint_unsnapped(active, order, packet.channels[0], raster, margin);
    int told = 0;
    for (std::size_t i = 0; i < painted.size(); ++i) {
        if (painted[i].near_an_edge) {
            ++agreement.near_edges;
            continue;
        }
        ++agreement.compared;
        support::SeenFace shown;
        if (picture.rank[i] != none) {
            const ProjectedFace& face = scene.projected.faces[static_cast<std::size_t>(picture.rank[i])];
            shown = {.block = face.block, .face = face.face};
            ++agreement.faces_seen;
        }
        if (!shown.same_face(painted[i]) && ++told < 5)
            ADD_FAILURE() << "column " << i % raster.width << " row " << i / raster.width << ": face "
                          << shown.face << " of block " << shown.block << ", the painter sees "
                          << painted[i].face << " of " << painted[i].block;
    }
}

TEST(UnsnappedPainter, PolygonsOfManyCorners) {
    Agreement agreement;
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        FramePacket packet;
        packet.channels = {channel_at({0, 0, 0}, 3.0 * static_cast<double>(seed), 2.0, 11.0)};
        packet.suns = {Vec3f(direction(1.0, 0.6))};
        const Scan scan = seed % 2 == 0 ? Scan::horizontal : Scan::vertical;
        expect_same_faces(random_polygons(seed, 150), packet, {123, 97, scan}, agreement);
    }
    EXPECT_GT(agreement.faces_seen, agreement.compared / 4);
    EXPECT_LT(agreement.near_edges, agreement.compared / 10); // most pixels tell something
}

TEST(UnsnappedPainter, TheShippedFlight) {
    const ShippedFlight flight = shipped_flight("first_flight/approach.toml", 30.0, {300, 599});
    ASSERT_EQ(flight.packets.size(), 2U);
    Agreement agreement;
    for (const FramePacket& packet : flight.packets) {
        SCOPED_TRACE("frame " + std::to_string(packet.frame));
        const Scan scan = packet.frame == 300 ? Scan::vertical : Scan::horizontal;
        expect_same_faces(flight.database, packet, {64, 48, scan}, agreement);
    }
    EXPECT_GT(agreement.faces_seen, agreement.compared * 9 / 10);
    EXPECT_GT(agreement.compared, 4000);
}

} // namespace
} // namespace linkdig::ig
