// Depth planes of many faces at a time are those of the faces one by one, bit for bit, at every SIMD level.

#include "ig/geometry/depth_batch.h"

#include "ig/geometry/depth_plane.h"
#include "ig/simd/simd_level.h"
#include "tests/ig/random_scene.h"
#include "tests/ig/small_database.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <numeric>
#include <string>
#include <vector>

namespace linkdig::ig {
namespace {

/// What is wrong with a face, if anything.
enum class Kind : std::uint8_t {
    sound,
    through_eye,  ///< its plane, within rounding or exactly
    no_area,      ///< corners in one place, or on a line
    late_area,    ///< its first three corners are on a line
    two_normals,  ///< of the same length, one against the other: the first one counts
    at_infinity,  ///< a corner, several or all
    half_weight,  ///< w is neither 0 nor 1
    far_away,     ///< coordinates of 1e6 m
    minute,       ///< so small that hardly a digit of its sides is left, or that it is a point
    many_corners, ///< more than four
};
constexpr std::int32_t kinds = 10;

struct Faces {
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> corners;
    std::vector<Face> faces;
};

Vec4f within(RandomStream& random, double range) {
    const auto part = [&] { return static_cast<float>(random.between(-range, range)); };
    return {part(), part(), part(), 1.0F};
}

/// Whole metres: their sums and products are exact.
Vec4f whole(RandomStream& random) {
    const auto part = [&] { return static_cast<float>(random.integer(-30, 30)); };
    return {part(), part(), part(), 1.0F};
}

/// From a towards b and beyond.
Vec4f along(const Vec4f& a, const Vec4f& b, float t) { return {Vec3f(a) + t * Vec3f(b - a), 1.0F}; }

std::vector<Vec4f> positions_of(Kind kind, std::size_t count, RandomStream& random) {
    std::vector<Vec4f> p(count);
    for (Vec4f& position : p)
        position =
            kind == Kind::through_eye || kind == Kind::two_normals ? whole(random) : within(random, 100.0);
    switch (kind) {
    case Kind::through_eye: // of a list whose origin is the eye
        for (std::size_t k = 2; k < count; ++k)
            p[k] = {static_cast<float>(k) * Vec3f(p[0]) - Vec3f(p[1]), 1.0F};
        break;
    case Kind::no_area:
        for (std::size_t k = 1; k < count; ++k)
            p[k] = random.one_in(2) ? p[0] : along(p[0], p[1], static_cast<float>(k));
        break;
    case Kind::late_area:
        p[2] = random.one_in(2) ? p[1] : along(p[0], p[1], 2.0F);
        break;
    case Kind::two_normals:
        if (count > 3) p[3] = {2.0F * Vec3f(p[0]) - Vec3f(p[2]), 1.0F};
        break;
    case Kind::at_infinity:
        for (std::size_t k = 0; k < count; ++k)
            if (k == 0 || random.one_in(2)) p[random.one_in(3) ? k : count - 1 - k].w = 0.0F;
        break;
    case Kind::half_weight:
        for (Vec4f& position : p)
            position.w = random.one_in(2) ? 0.5F : -1.0F;
        break;
    case Kind::far_away:
        for (Vec4f& position : p)
            position = within(random, 1e6);
        break;
    case Kind::minute:
        for (Vec4f& position : p)
            position = Vec4f(Vec3f(within(random, 1.0)) * (random.one_in(2) ? 1e-38F : 1e-6F), 1.0F);
        break;
    default:
        break;
    }
    return p;
}

void add_face(Kind kind, RandomStream& random, Faces& faces) {
    const std::int32_t count = kind == Kind::many_corners ? random.integer(5, 9) : random.integer(3, 4);
    Face face;
    face.first_corner = static_cast<std::uint32_t>(faces.corners.size());
    face.corner_count = static_cast<std::uint16_t>(count);
    for (const Vec4f& position : positions_of(kind, face.corner_count, random)) {
        faces.corners.push_back(static_cast<std::uint32_t>(faces.vertices.size()));
        faces.vertices.push_back({position, {}});
    }
    faces.faces.push_back(face);
}

using Bits = std::array<std::uint64_t, 5>;

Bits bits_of(const DepthPlane& plane) {
    const auto bits = [](double value) { return std::bit_cast<std::uint64_t>(value); };
    return {bits(plane.inverse_m), bits(plane.across), bits(plane.along), bits(plane.nearest_m),
            bits(plane.farthest_m)};
}

Bits expected(const BlockView& view, const Face& face) {
    std::vector<ClipPoint> corners;
    for (std::uint32_t k = 0; k < face.corner_count; ++k)
        corners.push_back(
            channel_point(view, view.block->vertices[view.block->corners[face.first_corner + k]].position));
    return bits_of(depth_plane(*view.view, corners));
}

/// The faces of a block from one viewpoint.
class Case {
public:
    Case(const Faces& faces, RandomStream& random) {
        block_.vertices = faces.vertices;
        block_.corners = faces.corners;
        block_.faces = faces.faces;
        const Raster raster{300, 200, random.one_in(2) ? Scan::vertical : Scan::horizontal};
        const bool turned = random.one_in(2);
        view_ = view_of(turned ? channel_at({0, 0, 0}, random.between(0.0, 360.0),
                                            random.between(-90.0, 90.0), random.between(0.0, 360.0))
                               : channel_at({0, 0, 0}),
                        raster);
        sight.view = &view_;
        sight.block = &block_;
        // Now and then the rotation is so small that squares of areas vanish.
        sight.channel_from_list = view_.channel_from_world * (random.one_in(8) ? 1e-45 : 1.0);
        if (random.one_in(2)) sight.origin = {random.between(-9.0, 9.0), random.between(-9.0, 9.0), 50.0};
    }

    BlockView sight;

private:
    FaceBlock block_;
    View view_;
};

void expect_every_level(const BlockView& sight, std::span<const std::uint32_t> wanted) {
    std::vector<ClipPoint> corners;
    for (const std::string& level : simd_levels()) {
        SCOPED_TRACE(level);
        ASSERT_TRUE(use_simd_level(level));
        std::vector<DepthPlane> planes(wanted.size());
        make_depth_planes(sight, wanted, corners, planes.data());
        for (std::size_t f = 0; f < wanted.size(); ++f)
            ASSERT_EQ(bits_of(planes[f]), expected(sight, sight.block->faces[wanted[f]])) << "face " << f;
    }
    use_simd_level("best");
}

TEST(DepthBatch, every_level_makes_the_planes_of_the_plain_way) {
    RandomStream random(1977);
    std::array<std::size_t, kinds> near{}, infinitely_far{};
    for (std::uint32_t i = 0; i < 3000; ++i) {
        SCOPED_TRACE("batch " + std::to_string(i));
        // Of one kind, or of any; now and then none has a fourth corner.
        const std::int32_t only = random.integer(-2, kinds - 1);
        Faces faces;
        std::vector<Kind> kind;
        while (faces.faces.size() < 1 + i % depths_together) {
            kind.push_back(static_cast<Kind>(only < 0 ? random.integer(0, kinds - 1) : only));
            add_face(kind.back(), random, faces);
            if (i % 3 == 0) faces.faces.back().corner_count = 3;
        }
        const Case seen(faces, random);
        std::vector<std::uint32_t> wanted(faces.faces.size());
        std::iota(wanted.rbegin(), wanted.rend(), 0U);
        expect_every_level(seen.sight, wanted);
        if (HasFatalFailure()) return;
        for (std::size_t f = 0; f < faces.faces.size(); ++f) {
            const bool far = expected(seen.sight, faces.faces[f])[0] == 0;
            ++(far ? infinitely_far : near)[static_cast<std::size_t>(kind[f])];
        }
    }
    for (const Kind kind : {Kind::through_eye, Kind::no_area, Kind::at_infinity, Kind::minute})
        EXPECT_GT(infinitely_far[static_cast<std::size_t>(kind)], 500U);
    for (const Kind kind : {Kind::sound, Kind::late_area, Kind::two_normals, Kind::half_weight,
                            Kind::far_away, Kind::minute, Kind::many_corners})
        EXPECT_GT(near[static_cast<std::size_t>(kind)], 500U);
}

TEST(DepthBatch, planes_stand_where_they_were_wanted) {
    RandomStream random(1978);
    Faces faces;
    for (std::uint32_t f = 0; f < 3 * depths_together; ++f)
        add_face(Kind::sound, random, faces);
    const Case seen(faces, random);
    DepthBatch batch;
    std::vector<DepthPlane> depths(5);
    for (std::uint32_t f = 0; f < faces.faces.size(); ++f) {
        EXPECT_EQ(batch.want(seen.sight, f, depths), static_cast<std::int32_t>(5 + f));
        if (f == 7) batch.make(seen.sight, depths);
    }
    batch.make(seen.sight, depths);
    batch.make(seen.sight, depths); // nothing is left
    ASSERT_EQ(depths.size(), 5 + faces.faces.size());
    for (std::uint32_t f = 0; f < faces.faces.size(); ++f)
        EXPECT_EQ(bits_of(depths[5 + f]), expected(seen.sight, faces.faces[f])) << "face " << f;
}

} // namespace
} // namespace linkdig::ig
