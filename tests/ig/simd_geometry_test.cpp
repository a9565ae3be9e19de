// Geometry by vectors against geometry face by face: every number that later stages read.

#include "ig/geometry/parts.h"
#include "ig/geometry/project.h"
#include "ig/simd/simd_level.h"
#include "tests/ig/random_scene.h"
#include "tests/ig/small_database.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <string>
#include <vector>

namespace linkdig::ig {
namespace {

/// One block of random faces in runs, with light points among them.
struct RandomBlock {
    VisualDatabase database;
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> corners;
    std::vector<Colour> colours;
    std::vector<Face> faces;
    std::vector<FaceRun> runs;
    std::vector<LightPoint> lights;
    ActiveDatabase active;
    PriorityOrder order;
};

Vec3f random_direction(RandomStream& random) {
    const auto part = [&] { return static_cast<float>(random.between(-1.0, 1.0)); };
    return glm::normalize(Vec3f(part(), part(), part()) + Vec3f(0, 0, 0.01F));
}

/// Around the eye, far away and close by, before the near plane and on it, in the eye's plane, in the eye, at infinity.
Vec4f random_position(RandomStream& random) {
    const auto within = [&](double range) { return static_cast<float>(random.between(-range, range)); };
    switch (random.integer(0, 9)) {
    case 0:
        return {random_direction(random), 0.0F}; // anywhere at infinity
    case 1:
        return {0.0F, within(1.0), within(1.0), 0.0F}; // at infinity, in the eye's plane
    case 2:
        return {0.0F, within(50.0), within(50.0), 1.0F}; // in the eye's plane
    case 3:
        return {0.25F, within(0.2), within(0.2), 1.0F}; // on the near plane
    case 4:
        return {0.3F, within(900.0), within(900.0), 1.0F}; // beyond the guard band
    case 5:
        return {0.0F, 0.0F, 0.0F, static_cast<float>(random.integer(0, 1))};
    case 6:
        return {within(1e6), within(1e6), within(1e6), 1.0F};
    default: {
        const auto ahead = static_cast<float>(random.between(-5.0, 100.0));
        return {ahead, ahead * within(0.9), ahead * within(0.9), 1.0F};
    }
    }
}

/// A small face ahead: the vertices stand around its middle, in order, now and then so close together that they share a place.
void add_small_polygon(RandomBlock& block, RandomStream& random, std::uint32_t count) {
    const auto depth = static_cast<float>(random.between(1.0, 500.0));
    const auto across = [&] { return depth * static_cast<float>(random.between(-0.75, 0.75)); };
    const Vec3f middle(depth, across(), across());
    const float size = depth * static_cast<float>(random.one_in(3) ? 1e-4 : random.between(0.0, 0.2));
    const Vec3f normal = random_direction(random);
    for (std::uint32_t k = 0; k < count; ++k) {
        const double angle = (random.one_in(2) ? 6.283 : -6.283) * (k + 0.3 * random.unit()) / count;
        const Vec3f place = middle + size * Vec3f(0.0F, static_cast<float>(std::cos(angle)),
                                                  static_cast<float>(std::sin(angle)));
        block.vertices.push_back({Vec4f(place, 1.0F), random.one_in(2) ? normal : random_direction(random)});
    }
}

/// Corners of a new face: new vertices of their own, or any that stand already.
void add_corners(RandomBlock& block, RandomStream& random, std::uint32_t count) {
    const auto first = static_cast<std::uint32_t>(block.vertices.size());
    const bool shared = first > 8 && random.one_in(4);
    if (!shared && random.one_in(3)) {
        for (std::uint32_t k = 0; k < count; ++k)
            block.vertices.push_back({random_position(random), random_direction(random)});
    } else if (!shared) {
        add_small_polygon(block, random, count);
    }
    for (std::uint32_t k = 0; k < count; ++k) {
        const auto any = [&] { return random.integer(0, static_cast<std::int32_t>(first) - 1); };
        block.corners.push_back(shared ? static_cast<std::uint32_t>(any()) : first + k);
        const auto code = [&] { return static_cast<std::uint8_t>(random.integer(0, 255)); };
        block.colours.push_back({code(), code(), code(), 0});
    }
}

void add_face(RandomBlock& block, RandomStream& random) {
    Face face;
    const std::uint32_t count = random.one_in(8) ? static_cast<std::uint32_t>(random.integer(5, 11))
                                                 : static_cast<std::uint32_t>(random.integer(3, 4));
    if (random.one_in(10)) { // a gap: corners do not always follow each other
        block.corners.push_back(0);
        block.colours.emplace_back();
    }
    face.first_corner = static_cast<std::uint32_t>(block.corners.size());
    face.corner_count = static_cast<std::uint16_t>(count);
    add_corners(block, random, count);
    face.colour = static_cast<std::uint16_t>(random.integer(0, 15));
    face.object = static_cast<std::uint32_t>(random.integer(0, 3));
    face.normal = random_direction(random);
    face.shading = static_cast<Shading>(random.integer(0, 2));
    face.two_sided = random.one_in(3) ? 1 : 0;
    face.coloured = random.one_in(6) ? 1 : 0;
    face.opacity = static_cast<std::uint16_t>(random.integer(1, 256));
    block.faces.push_back(face);
}

void add_run(RandomBlock& block, RandomStream& random) {
    FaceRun run;
    run.first_face = static_cast<std::uint32_t>(block.faces.size());
    run.face_count =
        static_cast<std::uint32_t>(random.one_in(2) ? random.integer(1, 9) : random.integer(1, 150));
    run.level = random.integer(-1, 1);
    run.radius = -1.0F;
    run.first_light = static_cast<std::uint32_t>(block.lights.size());
    for (std::uint32_t f = 0; f < run.face_count; ++f) {
        if (random.one_in(40)) {
            const auto across = [&] { return static_cast<float>(random.between(-20.0, 20.0)); };
            block.lights.push_back({.position = {50.0F, across(), across()}, .place = f, .intensity = 4.0F});
        }
        add_face(block, random);
    }
    run.light_count = static_cast<std::uint32_t>(block.lights.size()) - run.first_light;
    block.runs.push_back(run);
}

void activate_block(RandomBlock& block, RandomStream& random) {
    block.database.lists.emplace_back();
    ActiveDatabase& active = block.active;
    active.database = &block.database;
    active.level_opacity = {256, 100};
    if (random.one_in(3)) active.object_shed = {0, 1, 0, 0};
    FaceBlock made;
    made.at_eye = random.one_in(4);
    made.origin_m = {random.between(-1.0, 1.0), random.between(-1.0, 1.0), 0.0};
    made.sun = random_direction(random);
    made.ambient = 0.3F;
    made.smooth = !random.one_in(4);
    made.colour = random.one_in(4) ? 7 : none;
    made.vertices = block.vertices;
    made.corners = block.corners;
    if (!random.one_in(4)) made.corner_colours = block.colours;
    made.faces = block.faces;
    made.runs = block.runs;
    made.lights = block.lights;
    active.blocks.push_back(made);
    for (std::uint32_t r = 0; r < block.runs.size(); ++r)
        block.order.runs.push_back({0, r});
}

/// Filled where it stays: its parts refer to each other.
void fill(RandomBlock& block, RandomStream& random) {
    add_corners(block, random, 9); // so that there is something to share
    for (std::int32_t runs = random.integer(1, 4); runs > 0; --runs)
        add_run(block, random);
    activate_block(block, random);
}

using Numbers = std::vector<std::int64_t>;

void add_triangle(const IntensityTriangle& triangle, Numbers& numbers) {
    for (std::size_t k = 0; k < 3; ++k)
        numbers.insert(numbers.end(),
                       {std::bit_cast<std::int64_t>(triangle.line[k]),
                        std::bit_cast<std::int64_t>(triangle.element[k]), triangle.intensity[k]});
}

/// A face, with all that it refers to.
Numbers numbers_of(const ProjectedFaces& projected, const ProjectedFace& face) {
    Numbers numbers{face.colour,           face.intensity, face.block, face.face,  face.list,
                    face.added_to,         face.opacity,   face.fade,  face.level, face.triangle < 0,
                    face.colour_step == 0, face.depth < 0};
    for (std::uint32_t k = 0; k < face.point_count; ++k) {
        const RasterPoint& point = projected.points[face.first_point + k];
        numbers.insert(numbers.end(), {point.line, point.element});
    }
    for (std::uint32_t k = 0; face.triangle >= 0 && k < (face.colour_step == 0 ? 1U : 3U); ++k)
        add_triangle(projected.triangles[static_cast<std::uint32_t>(face.triangle) + k * face.colour_step],
                     numbers);
    if (face.depth >= 0) {
        const DepthPlane& plane = projected.depths[static_cast<std::size_t>(face.depth)];
        for (const double value :
             {plane.inverse_m, plane.across, plane.along, plane.nearest_m, plane.farthest_m})
            numbers.push_back(std::bit_cast<std::int64_t>(value));
    }
    return numbers;
}

void expect_the_same(const ProjectedFaces& a, const ProjectedFaces& b) {
    ASSERT_EQ(a.faces.size(), b.faces.size());
    for (std::size_t rank = 0; rank < a.faces.size(); ++rank)
        ASSERT_EQ(numbers_of(a, a.faces[rank]), numbers_of(b, b.faces[rank])) << "rank " << rank;
    EXPECT_EQ(a.offered, b.offered);
    EXPECT_EQ(a.depths.size(), b.depths.size());
    ASSERT_EQ(a.lights.size(), b.lights.size());
    for (std::size_t k = 0; k < a.lights.size(); ++k) {
        EXPECT_EQ(a.lights[k].at, b.lights[k].at);
        EXPECT_EQ(a.lights[k].rank, b.lights[k].rank);
    }
}

TEST(SimdGeometry, every_level_projects_the_faces_of_the_plain_way) {
    RandomStream random(1979);
    std::size_t faces = 0, offered = 0;
    for (int i = 0; i < 400; ++i) {
        SCOPED_TRACE("block " + std::to_string(i));
        RandomBlock block;
        fill(block, random);
        const Raster raster{300, 200, random.one_in(2) ? Scan::vertical : Scan::horizontal};
        const GeometryNeeds needs{.depth = random.one_in(2), .low_faces = random.one_in(3)};
        const ChannelView view = i % 2 == 0
                                     ? channel_at({0, 0, 0})
                                     : channel_at({0, 0, 0}, random.between(0.0, 360.0),
                                                  random.between(-90.0, 90.0), random.between(0.0, 360.0));
        const auto projected_by = [&](const std::string& level) {
            EXPECT_TRUE(use_simd_level(level));
            GeometryScratch scratch;
            ProjectedFaces projected;
            project(block.active, block.order, whole_of(block.order), view, raster, needs, scratch,
                    projected);
            return projected;
        };
        const ProjectedFaces plain = projected_by("scalar");
        for (const std::string& level : simd_levels()) {
            SCOPED_TRACE(level);
            expect_the_same(plain, projected_by(level));
        }
        faces += plain.faces.size();
        offered += plain.offered;
    }
    use_simd_level("best");
    EXPECT_GT(faces, 10000U);
    EXPECT_GT(offered - faces, 10000U); // and many are not seen
}

} // namespace
} // namespace linkdig::ig
