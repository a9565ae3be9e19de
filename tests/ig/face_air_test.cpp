// The air before a face as a plane of transmission, against that of every pixel.

#include "ig/video/face_air.h"

#include "database/model/random.h"
#include "ig/simd/simd_level.h"
#include "ig/video/inverse_range.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>

namespace linkdig::ig {
namespace {

constexpr std::uint32_t side = 512;
/// Tangents from -0.58 to 0.58: 60 degrees.
constexpr PictureScale scale{256.0 * side / 1.16, 128.0 * side, -256.0 * side / 1.16, 128.0 * side};

Air air_of(double visibility_m, Scan scan) {
    Air air;
    air.prepare(scale, {side, side, scan}, visibility_m, {});
    return air;
}

/// Faces of which nothing but their place and their depth is known.
struct Faces {
    ProjectedFaces projected;
    FaceEdges edges;

    void add(const DepthPlane& depth, std::int32_t first_line, std::int32_t end_line,
             std::int32_t first_element, std::int32_t end_element) {
        ProjectedFace face;
        face.depth = static_cast<std::int32_t>(projected.depths.size());
        projected.depths.push_back(depth);
        projected.faces.push_back(face);
        EdgeFace edge;
        edge.first_line = first_line;
        edge.end_line = end_line;
        edge.first_element = first_element;
        edge.end_element = end_element;
        edges.faces.push_back(edge);
    }
};

/// Boxes anywhere, with ranges from 1 m to 30 km at their middle and planes from face-on to edge-on.
Faces random_faces(std::uint64_t seed, std::size_t count) {
    Faces faces;
    for (std::size_t k = 0; k < count; ++k) {
        const auto unit = [&](std::uint64_t n) { return random_unit(seed, 16 * k + n); };
        const auto place = [&](std::uint64_t n, std::int32_t most) {
            return static_cast<std::int32_t>(unit(n) * most);
        };
        const std::int32_t size = k % 3 == 0 ? 200 : 24;
        const std::int32_t line = place(0, side - 1), element = place(1, side - 1);
        const std::int32_t end_line = std::min(line + 1 + place(2, size), std::int32_t{side});
        const std::int32_t end_element = std::min(element + 1 + place(3, size), std::int32_t{side});
        const double middle = 1.0 / std::pow(10.0, 4.5 * unit(4));
        const double steepness = std::pow(10.0, -6.0 * unit(5));
        const double along = middle * steepness * (unit(6) - 0.5),
                     across = middle * steepness * (unit(7) - 0.5);
        const double corner =
            middle - along * (element + end_element) / 2.0 - across * (line + end_line) / 2.0;
        faces.add(
            {.inverse_m = corner, .across = across, .along = along, .nearest_m = 0, .farthest_m = INFINITY},
            line, end_line, element, end_element);
    }
    return faces;
}

/// The greatest difference over a face's box from the transmission of the pixel itself, in 1 / 32767.
int greatest_difference(const Faces& faces, std::size_t rank, const Air& air, const FaceAir& face_air) {
    const EdgeFace& box = faces.edges.faces[rank];
    int greatest = 0;
    for (std::int32_t line = box.first_line; line < box.end_line; ++line)
        for (std::int32_t element = box.first_element; element < box.end_element; ++element)
            greatest = std::max(greatest,
                                std::abs(planar_transmission(face_air.transmission, line, element) -
                                         transmission_of(faces.projected.depths[rank], air, line, element)));
    return greatest;
}

TEST(FaceAir, APlaneIsAtMostAThirdOfALevelOff) {
    constexpr double third_of_a_level = transmission_one / (3.0 * 255.0);
    const Faces faces = random_faces(1, 1500);
    int planes = 0, by_pixel = 0, greatest = 0;
    for (const Scan scan : {Scan::horizontal, Scan::vertical})
        for (const double visibility_m : {100.0, 1000.0, 5000.0, 40000.0}) {
            const Air air = air_of(visibility_m, scan);
            std::vector<FaceAir> face_air;
            judge_air(faces.projected, faces.edges, air, face_air);
            for (std::size_t rank = 0; rank < face_air.size(); ++rank) {
                ++(face_air[rank].kind == AirKind::plane ? planes : by_pixel);
                if (face_air[rank].kind == AirKind::plane)
                    greatest = std::max(greatest, greatest_difference(faces, rank, air, face_air[rank]));
            }
        }
    EXPECT_LE(greatest, third_of_a_level + 3.0); // both are rounded, and the plane's slopes
    EXPECT_GT(greatest, third_of_a_level / 4);   // some come near
    EXPECT_GT(planes, 4000);
    EXPECT_GT(by_pixel, 1000);
}

TEST(FaceAir, WhereNothingChangesItIsFlat) {
    Faces faces;
    const double infinite = std::numeric_limits<double>::infinity();
    faces.add({.inverse_m = 0, .across = 0, .along = 0, .nearest_m = infinite, .farthest_m = infinite}, 0,
              512, 0, 512);
    faces.add({.inverse_m = -1, .across = 0.1, .along = 0.1, .nearest_m = 0.3, .farthest_m = 0.5}, 0, 512, 0,
              512);
    faces.add({.inverse_m = -1, .across = 0.1, .along = 0.1, .nearest_m = 0.3, .farthest_m = 5000}, 0, 512, 0,
              512);
    faces.projected.faces.emplace_back(); // stands at the eye
    faces.edges.faces.emplace_back();
    const Air air = air_of(5000.0, Scan::horizontal);
    std::vector<FaceAir> face_air;
    judge_air(faces.projected, faces.edges, air, face_air);
    ASSERT_EQ(face_air.size(), 4U);
    EXPECT_EQ(face_air[0].kind, AirKind::plane); // as the horizon
    EXPECT_EQ(planar_transmission(face_air[0].transmission, 3, 500), 0);
    EXPECT_EQ(face_air[1].kind, AirKind::plane); // before the nose, and through the eye's plane
    EXPECT_GE(planar_transmission(face_air[1].transmission, 400, 2), transmission_one - 20);
    EXPECT_EQ(face_air[2].kind, AirKind::by_pixel);
    EXPECT_EQ(face_air[3].kind, AirKind::clear);
    judge_air(faces.projected, faces.edges, air_of(0.0, Scan::horizontal), face_air);
    EXPECT_TRUE(face_air.empty());
}

TEST(FaceAir, EveryLevelGivesTheSameNumbers) {
    Faces faces = random_faces(2, 3001);
    const double infinite = std::numeric_limits<double>::infinity();
    for (const double inverse_m : {0.0, -1.0, 1e-300, 1e300, infinite, std::nan("")})
        for (const double along : {0.0, 1e-310, -1e-4, 1e200, infinite, std::nan("")})
            faces.add(
                {.inverse_m = inverse_m, .across = -along, .along = along, .nearest_m = 1, .farthest_m = 2},
                0, 0, 512, 512);
    const Air air = air_of(3000.0, Scan::vertical);
    std::vector<FaceAir> plain, made;
    ASSERT_TRUE(use_simd_level("scalar"));
    judge_air(faces.projected, faces.edges, air, plain);
    for (const std::string& level : simd_levels()) {
        ASSERT_TRUE(use_simd_level(level));
        judge_air(faces.projected, faces.edges, air, made);
        ASSERT_EQ(made.size(), plain.size());
        for (std::size_t rank = 0; rank < plain.size(); ++rank) {
            const IntensityPlane &a = made[rank].transmission, &b = plain[rank].transmission;
            ASSERT_EQ(made[rank].kind, plain[rank].kind) << level << ", face " << rank;
            ASSERT_TRUE(a.reference_line == b.reference_line && a.reference_element == b.reference_element &&
                        a.value == b.value && a.along == b.along && a.across == b.across &&
                        a.least == b.least && a.greatest == b.greatest)
                << level << ", face " << rank;
        }
    }
    ASSERT_TRUE(use_simd_level("best"));
}

} // namespace
} // namespace linkdig::ig
