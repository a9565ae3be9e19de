// A channel's faces projected in parts are the faces projected at once.

#include "ig/geometry/parts.h"

#include "ig/active/activate.h"
#include "ig/edges/edges.h"
#include "ig/geometry/project.h"
#include "ig/priority/prioritise.h"
#include "tests/ig/small_database.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace linkdig::ig {
namespace {

struct Stages {
    ProjectedFaces projected;
    FaceEdges edges;
};

Stages in_parts(const ActiveDatabase& active, const PriorityOrder& order, const ChannelView& view,
                std::size_t parts) {
    const Raster raster{200, 200, Scan::horizontal};
    std::vector<OrderPart> cut;
    cut_order(active, order, count_faces(active, order), parts, cut);
    EXPECT_EQ(cut.size(), parts);
    GeometryScratch scratch;
    Stages all;
    for (const OrderPart& part : cut) {
        Stages one;
        project(active, order, part, view, raster, {.depth = true, .low_faces = true}, scratch,
                one.projected);
        make_edges(one.projected, raster, true, one.edges);
        append(one.projected, all.projected);
        append(one.edges, all.edges);
    }
    return all;
}

/// Everything that later stages read of a face, in one row of numbers.
std::vector<std::int64_t> face_numbers(const Stages& stages, std::size_t rank) {
    const ProjectedFace& face = stages.projected.faces[rank];
    const EdgeFace& made = stages.edges.faces[rank];
    std::vector<std::int64_t> numbers{face.block,      face.face,     face.colour,
                                      face.intensity,  made.leading,  made.trailing,
                                      made.first_line, made.end_line, made.outlines};
    for (std::size_t k = 0; k < face.point_count; ++k) {
        const RasterPoint& point = stages.projected.points[face.first_point + k];
        numbers.insert(numbers.end(), {point.line, point.element});
    }
    for (std::size_t k = 0; k < std::size_t{made.leading} + made.trailing; ++k) {
        const Edge& edge = stages.edges.edges[made.first_edge + k];
        numbers.insert(numbers.end(), {edge.first_line, edge.end_line, edge.start, edge.slope});
    }
    for (std::size_t k = 0; k < made.outlines; ++k)
        numbers.push_back(stages.edges.outlines[made.first_outline + k].start);
    const FaceShading& shading = stages.edges.shadings[rank];
    const IntensityPlane& plane = shading.plane;
    numbers.insert(numbers.end(),
                   {shading.colour, plane.value, plane.along, plane.across, plane.least, plane.greatest});
    return numbers;
}

void expect_the_same(const Stages& a, const Stages& b) {
    ASSERT_EQ(a.projected.faces.size(), b.projected.faces.size());
    for (std::size_t rank = 0; rank < a.projected.faces.size(); ++rank)
        ASSERT_EQ(face_numbers(a, rank), face_numbers(b, rank)) << rank;
    EXPECT_EQ(a.projected.offered, b.projected.offered);
    EXPECT_EQ(a.projected.depths.size(), b.projected.depths.size());
    EXPECT_EQ(a.projected.lights_offered, b.projected.lights_offered);
    ASSERT_EQ(a.projected.lights.size(), b.projected.lights.size());
    for (std::size_t k = 0; k < a.projected.lights.size(); ++k) {
        EXPECT_EQ(a.projected.lights[k].rank, b.projected.lights[k].rank);
        EXPECT_EQ(a.projected.lights[k].at, b.projected.lights[k].at);
    }
    EXPECT_EQ(a.projected.lights_at_step, b.projected.lights_at_step);
}

/// Boxes before the sea, each with a light before its first, third, and fifth face, and behind the last.
VisualDatabase lit_boxes() {
    VisualDatabase database = sea_database();
    for (std::uint32_t k = 0; k < 5; ++k) {
        const auto x = static_cast<float>(40 + 10 * k);
        add_box(database, {.from = {x, x - 10, 2}, .to = {x + 4, x - 2, 9}, .group = k});
    }
    for (FaceRun& run : database.runs) {
        run.first_light = static_cast<std::uint32_t>(database.lights.size());
        for (std::uint32_t place = 0; place <= run.face_count; place += 2)
            database.lights.push_back({.position = {50, 30, 12}, .place = place});
        run.light_count = static_cast<std::uint32_t>(database.lights.size()) - run.first_light;
    }
    return database;
}

void compare_cuts(const VisualDatabase& database) {
    FramePacket packet;
    packet.channels = {channel_at({3, 4, 25}, 33.0, -10.0, 14.0)};
    packet.suns = {Vec3f(0, 0, 1)};
    packet.moving_objects.resize(database.moving_objects.size());
    ActiveDatabase active;
    History history;
    activate(database, packet, {}, history, active);
    PriorityOrder order;
    PriorityScratch scratch;
    prioritise(active, packet.channels[0], scratch, order);
    const Stages whole = in_parts(active, order, packet.channels[0], 1);
    EXPECT_GT(whole.projected.faces.size(), 5U);
    for (const std::size_t parts : {2U, 3U, 7U, 64U, 1000U}) {
        SCOPED_TRACE(parts);
        expect_the_same(in_parts(active, order, packet.channels[0], parts), whole);
    }
}

TEST(Parts, OfTheSeaAreTheSea) { compare_cuts(sea_database()); }

TEST(Parts, CutInsideARunKeepItsLightsBetweenTheirFaces) { compare_cuts(lit_boxes()); }

TEST(Parts, OfNothingAreNothing) {
    std::vector<OrderPart> cut;
    cut_order({}, {}, 0, 3, cut);
    ASSERT_EQ(cut.size(), 3U);
    for (const OrderPart& part : cut)
        EXPECT_EQ(part.from, part.to);
}

} // namespace
} // namespace linkdig::ig
