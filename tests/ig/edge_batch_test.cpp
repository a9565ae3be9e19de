// Edges and intensity planes of many faces at a time are those of the faces one by one, at every SIMD level.

#include "ig/edges/edge_batch.h"

#include "database/model/random.h"
#include "ig/edges/edges.h"
#include "ig/geometry/parts.h"
#include "ig/simd/simd_level.h"

#include <gtest/gtest.h>

#include <string>

namespace linkdig::ig {
namespace {

constexpr Raster raster{96, 64, Scan::horizontal};
constexpr std::int32_t guard_band = 32767 * subpixels;

class Numbers {
public:
    explicit Numbers(std::uint64_t seed) : seed_(seed) {}
    std::uint64_t below(std::uint64_t end) { return random_bits(seed_, drawn_++) % end; }
    std::int32_t within(std::int32_t from, std::int32_t to) {
        return from + static_cast<std::int32_t>(below(static_cast<std::uint64_t>(to - from) + 1));
    }

private:
    std::uint64_t seed_;
    std::uint64_t drawn_ = 0;
};

/// Where a face's corners lie, 1/256 pixel.
RasterPoint random_point(Numbers& numbers, std::uint64_t kind, const RasterPoint& first) {
    switch (kind) {
    case 0:
        return {numbers.within(-guard_band, guard_band), numbers.within(-guard_band, guard_band)};
    case 1:
        return {numbers.below(2) == 0 ? -guard_band : guard_band, numbers.within(-1, 1) * guard_band};
    case 2:
        return {first.line + numbers.within(-200, 200), first.element + numbers.within(-200, 200)};
    case 3:
        return {first.line, numbers.within(-4000, 40000)}; // no height
    case 4:
        return {numbers.within(-1, 1) * 128 + 1024, numbers.within(0, 511)}; // on centres, or hardly off
    default:
        return {numbers.within(-4000, 20000), numbers.within(-4000, 30000)};
    }
}

/// A face's triangle: its first corners, or three points that were not snapped, far outside.
IntensityTriangle random_triangle(Numbers& numbers, const RasterPoint* corners, bool clipped) {
    IntensityTriangle triangle;
    const std::int32_t first = numbers.within(0, intensity_one);
    const std::int32_t most = numbers.below(4) == 0 ? 0 : intensity_one;
    for (std::size_t k = 0; k < 3; ++k) {
        triangle.line[k] = corners[k].line;
        triangle.element[k] = corners[k].element;
        triangle.intensity[k] = most == 0 ? first : numbers.within(0, most);
    }
    if (clipped) triangle.line[numbers.below(3)] = 1e6 * numbers.within(-256'000'000, 256'000'000) + 0.37;
    if (clipped && numbers.below(2) == 0) triangle.element[numbers.below(3)] = 1e-3 * numbers.within(-9, 9);
    return triangle;
}

void add_face(Numbers& numbers, ProjectedFaces& projected) {
    const std::uint64_t kind = numbers.below(8);
    const std::uint64_t corners = numbers.below(40) == 0 ? 5 : numbers.below(3) == 0 ? 4 : 3;
    ProjectedFace face;
    face.first_point = static_cast<std::uint32_t>(projected.points.size());
    face.point_count = static_cast<std::uint16_t>(corners);
    const RasterPoint first = random_point(numbers, kind == 2 || kind == 3 ? 5 : kind, {});
    projected.points.push_back(first);
    for (std::uint64_t k = 1; k < corners; ++k)
        projected.points.push_back(random_point(numbers, kind, first));
    if (numbers.below(30) == 0) projected.points.back() = first;
    face.colour = static_cast<std::uint16_t>(numbers.below(65536));
    face.intensity = numbers.within(0, intensity_one);
    face.depth = numbers.within(-1, 0);
    face.added_to = numbers.below(20) == 0 ? 3 : -1;
    if (numbers.below(20) == 0) face.opacity = 100;
    if (numbers.below(20) == 0) {
        face.fade = 60;
        face.level = 2;
    }
    if (numbers.below(5) != 0) {
        face.triangle = static_cast<std::int32_t>(projected.triangles.size());
        face.colour_step = numbers.below(50) == 0 ? 1 : 0;
        for (std::uint32_t k = 0; k < 1 + 2 * face.colour_step; ++k)
            projected.triangles.push_back(
                random_triangle(numbers, projected.points.data() + face.first_point, numbers.below(10) == 0));
    }
    projected.faces.push_back(face);
}

ProjectedFaces random_faces(std::uint64_t seed, std::size_t count) {
    Numbers numbers(seed);
    ProjectedFaces projected;
    for (std::size_t k = 0; k < count; ++k)
        add_face(numbers, projected);
    return projected;
}

void add_numbers(const IntensityPlane& plane, std::vector<std::int64_t>& numbers) {
    numbers.insert(numbers.end(), {plane.reference_line, plane.reference_element, plane.value, plane.along,
                                   plane.across, plane.least, plane.greatest});
}

/// Everything that the stage makes of a face.
std::vector<std::int64_t> face_numbers(const FaceEdges& edges, std::size_t rank) {
    const EdgeFace& face = edges.faces[rank];
    const FaceShading& shading = edges.shadings[rank];
    std::vector<std::int64_t> numbers{
        face.first_edge,    face.leading,     face.trailing,  face.first_line,
        face.end_line,      face.blends,      face.additive,  face.opacity,
        face.fade,          face.outlines,    face.level,     face.first_outline,
        face.first_element, face.end_element, shading.colour, shading.coloured};
    add_numbers(shading.plane, numbers);
    if (shading.coloured)
        for (const IntensityPlane& plane : tint_of(edges, shading))
            add_numbers(plane, numbers);
    for (std::size_t k = 0; k < std::size_t{face.leading} + face.trailing; ++k) {
        const Edge& edge = edges.edges[face.first_edge + k];
        numbers.insert(numbers.end(), {edge.first_line, edge.end_line, edge.start, edge.slope});
    }
    return numbers;
}

void expect_the_same(const FaceEdges& made, const FaceEdges& plain) {
    ASSERT_EQ(made.faces.size(), plain.faces.size());
    ASSERT_EQ(made.shadings.size(), plain.shadings.size());
    ASSERT_EQ(made.edges.size(), plain.edges.size());
    for (std::size_t rank = 0; rank < plain.faces.size(); ++rank)
        ASSERT_EQ(face_numbers(made, rank), face_numbers(plain, rank)) << "face " << rank;
}

TEST(EdgeBatch, EveryLevelGivesTheSameNumbers) {
    FaceEdges made; // holds the last ones' when the next are made
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        const ProjectedFaces projected = random_faces(seed, seed % 7 == 0 ? seed / 7 : 300);
        FaceEdges plain;
        ASSERT_TRUE(use_simd_level("scalar"));
        make_edges(projected, raster, false, plain);
        for (const std::string& level : simd_levels()) {
            SCOPED_TRACE(level + ", seed " + std::to_string(seed));
            ASSERT_TRUE(use_simd_level(level));
            make_edges(projected, raster, false, made);
            ASSERT_NO_FATAL_FAILURE(expect_the_same(made, plain));
        }
    }
    EXPECT_TRUE(use_simd_level("best"));
}

TEST(EdgeBatch, PartsJoinedAreTheWhole) {
    ProjectedFaces whole;
    FaceEdges joined;
    for (std::uint64_t seed = 0; seed < 3; ++seed) {
        const ProjectedFaces projected = random_faces(seed, 200); // some are coloured
        FaceEdges part;
        make_edges(projected, raster, false, part);
        append(part, joined);
        append(projected, whole);
    }
    FaceEdges made;
    make_edges(whole, raster, false, made);
    EXPECT_GT(made.tints.size(), 2U);
    expect_the_same(joined, made);
}

TEST(EdgeBatch, TakesWhatItIsFor) {
    ProjectedFaces projected = random_faces(1, 100);
    for (ProjectedFace& face : projected.faces) {
        face.colour_step = 0;
        face.point_count = 3;
    }
    projected.faces[70].point_count = 5;
    FaceEdges made;
    made.faces.resize(100);
    made.shadings.resize(100);
    std::size_t edges_made = 0;
    std::size_t rank = 0;
    while (const std::size_t dealt_with = make_edges_together(projected, rank, 64, 96, made, edges_made))
        rank += dealt_with;
    EXPECT_TRUE(rank == 70 || rank == 0) << rank; // none where vectors are narrow
    EXPECT_EQ(edges_made > 0, rank > 0);
}

} // namespace
} // namespace linkdig::ig
