// Edge smoothing against exact areas.

#include "tests/ig/small_database.h"

#include "database/model/mathematics.h"
#include "database/model/random.h"
#include "ig/edges/edges.h"
#include "ig/machine/machine.h"
#include "ig/scanline/bands.h"
#include "ig/scanline/open_mask.h"
#include "ig/scanline/scanline.h"
#include "ig/simd/simd_level.h"
#include "ig/video/video.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace linkdig::ig {
namespace {

constexpr std::uint32_t side = 48;

double between(std::uint64_t seed, std::uint64_t index, double least, double greatest) {
    return least + (greatest - least) * random_unit(seed, index);
}

/// Area of a polygon inside the unit square at (column, row), by clipping it against the square's four sides.
double area_in_pixel(std::vector<Vec2d> polygon, double column, double row) {
    const Vec2d normals[4] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};
    const double limits[4] = {column, -(column + 1), row, -(row + 1)};
    for (int plane = 0; plane < 4; ++plane) {
        std::vector<Vec2d> kept;
        for (std::size_t k = 0; k < polygon.size(); ++k) {
            const Vec2d a = polygon[k];
            const Vec2d b = polygon[(k + 1) % polygon.size()];
            const double da = glm::dot(a, normals[plane]) - limits[plane];
            const double db = glm::dot(b, normals[plane]) - limits[plane];
            if (da >= 0) kept.push_back(a);
            if ((da >= 0) != (db >= 0)) kept.push_back(a + (b - a) * (da / (da - db)));
        }
        polygon = kept;
    }
    double twice = 0.0;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Vec2d a = polygon[k];
        const Vec2d b = polygon[(k + 1) % polygon.size()];
        twice += a.x * b.y - b.x * a.y;
    }
    return 0.5 * std::fabs(twice);
}

/// A convex polygon: points of an ellipse in order, of positive area.
ProjectedFace add_polygon(std::uint64_t seed, double size, ProjectedFaces& projected) {
    ProjectedFace face;
    face.first_point = static_cast<std::uint32_t>(projected.points.size());
    face.point_count = static_cast<std::uint16_t>(3 + random_bits(seed, 0) % 6);
    const double e = between(seed, 1, -5, side + 5), l = between(seed, 2, -5, side + 5);
    const double width = between(seed, 3, 0.1, size), height = between(seed, 4, 0.1, size);
    const double turn = between(seed, 5, 0, two_pi);
    for (int k = 0; k < face.point_count; ++k) {
        const SineCosine at =
            sine_cosine(turn + two_pi * (k + between(seed, 10U + static_cast<std::uint64_t>(k), 0, 0.9)) /
                                   face.point_count);
        projected.points.push_back({static_cast<std::int32_t>(std::floor(256 * (l + height * at.sine))),
                                    static_cast<std::int32_t>(std::floor(256 * (e + width * at.cosine)))});
    }
    return face;
}

std::vector<Vec2d> outline_of(const ProjectedFaces& projected, const ProjectedFace& face) {
    std::vector<Vec2d> polygon;
    for (std::uint32_t k = 0; k < face.point_count; ++k) {
        const RasterPoint& p = projected.points[face.first_point + k];
        polygon.emplace_back(p.element / 256.0, p.line / 256.0);
    }
    return polygon;
}

VideoFrame draw(const ProjectedFaces& projected, const std::vector<Colour>& colours,
                std::vector<BandSegments>& bands) {
    const Raster raster{side, side, Scan::horizontal};
    FaceEdges edges;
    make_edges(projected, raster, true, edges);
    Bands sorted;
    sort_into_bands(edges, side, sorted);
    VideoFrame picture;
    open_frame(raster, false, false, picture);
    const Air clear;
    const VideoInput input{&projected, &edges, colours, {0, 0, 0}, &clear};
    BandScratch scratch;
    VideoScratch video;
    bands.resize(band_count(side));
    for (std::uint32_t band = 0; band < bands.size(); ++band) {
        bands[band].first_line = band * band_lines;
        bands[band].end_line = std::min((band + 1) * band_lines, side);
        resolve_band(edges, sorted.of(band), side, true, scratch, bands[band]);
        draw_band(input, raster, bands[band], video, picture);
    }
    return picture;
}

TEST(Smoothing, CoverageIsTheAreaOfTheOutline) {
    double sum = 0.0;
    int edge_pixels = 0;
    for (std::uint64_t seed = 1; seed <= 400; ++seed) {
        ProjectedFaces projected;
        projected.faces = {add_polygon(seed, seed % 3 == 0 ? 60 : 6, projected)};
        FaceEdges edges;
        make_edges(projected, {side, side, Scan::horizontal}, true, edges);
        OutlineLine traced;
        LineCoverage coverage;
        for (std::int32_t line = edges.faces[0].first_line; line < edges.faces[0].end_line; ++line) {
            trace_line(edges.outlines, line, side, traced);
            cover_line(traced, side, coverage);
            std::vector<double> covered(side, 0.0);
            for (const PartlyCovered& part : coverage.parts) {
                for (std::int32_t e = part.begin; e < part.end; ++e)
                    covered[static_cast<std::size_t>(e)] +=
                        coverage.areas[part.first + static_cast<std::size_t>(e - part.begin)] /
                        static_cast<double>(whole_pixel);
            }
            for (std::int32_t e = coverage.whole_begin; e < coverage.whole_end; ++e)
                covered[static_cast<std::size_t>(e)] += 1.0;
            for (std::size_t e = 0; e < side; ++e) {
                const double exact =
                    area_in_pixel(outline_of(projected, projected.faces[0]), static_cast<double>(e), line);
                // An edge's position at a line's border is rounded to 1/256 pixel, and so is where it leaves a pixel.
                ASSERT_NEAR(covered[e], exact, 1.5 / 256.0)
                    << "seed " << seed << " line " << line << " element " << e;
                if (exact > 0.0 && exact < 1.0) {
                    sum += std::fabs(covered[e] - exact);
                    ++edge_pixels;
                }
            }
        }
    }
    EXPECT_GT(edge_pixels, 10000);
    EXPECT_LT(sum / edge_pixels, 0.5 / 256.0);
}

TEST(Smoothing, EveryLevelGivesTheSameBytes) {
    // Slivers, small and large faces over each other, flush with pixels and lines now and then.
    const std::vector<Colour> colours{{250, 3, 70, 0}, {9, 200, 120, 0}, {90, 91, 240, 0}};
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        ProjectedFaces projected;
        for (std::uint64_t k = 0; k < 50; ++k) {
            const double size = k % 3 == 0 ? 40.0 : k % 3 == 1 ? 7.0 : 1.5;
            ProjectedFace face = add_polygon(1000 * seed + k, size, projected);
            face.colour = static_cast<std::uint16_t>(k % colours.size());
            projected.faces.push_back(face);
            if (k % 4 != 0) continue;
            for (std::size_t p = face.first_point; p < projected.points.size(); ++p)
                projected.points[p] = {projected.points[p].line & ~127, projected.points[p].element & ~255};
        }
        std::vector<std::uint32_t> expected;
        std::vector<BandSegments> bands;
        for (const std::string& level : simd_levels()) {
            ASSERT_TRUE(use_simd_level(level));
            const VideoFrame picture = draw(projected, colours, bands);
            if (expected.empty()) expected = picture.pixels;
            EXPECT_TRUE(picture.pixels == expected) << level << ", seed " << seed;
        }
        ASSERT_TRUE(use_simd_level("best"));
    }
}

TEST(Smoothing, NeighboursOfAMeshFillEveryPixelExactly) {
    // A jittered grid of triangles over the whole picture and beyond: nothing of the background, nothing twice.
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        constexpr int cells = 9;
        ProjectedFaces projected;
        const auto corner = [&](int i, int j) {
            const auto index = static_cast<std::uint64_t>(i * 100 + j);
            return RasterPoint{
                static_cast<std::int32_t>(256 * (-6 + 7.0 * j + between(seed, 2 * index, 0, 5))),
                static_cast<std::int32_t>(256 * (-6 + 7.0 * i + between(seed, 2 * index + 1, 0, 5)))};
        };
        for (int i = 0; i < cells; ++i) {
            for (int j = 0; j < cells; ++j) {
                const RasterPoint square[4] = {corner(i, j), corner(i + 1, j), corner(i + 1, j + 1),
                                               corner(i, j + 1)};
                for (const int third : {1, 2}) {
                    ProjectedFace face;
                    face.first_point = static_cast<std::uint32_t>(projected.points.size());
                    face.point_count = 3;
                    face.colour = static_cast<std::uint16_t>((i + j) % 2);
                    projected.points.insert(projected.points.end(),
                                            {square[0], square[third], square[third + 1]});
                    projected.faces.push_back(face);
                }
            }
        }
        std::vector<BandSegments> bands;
        draw(projected, {{200, 0, 0}, {0, 200, 0}}, bands);
        for (const BandSegments& band : bands) {
            EXPECT_TRUE(band.background.empty());
            const std::size_t length = std::size_t{band.words} * word_bits;
            std::vector<std::uint64_t> total(band.shared.size() * word_bits, 0);
            for (const ShareRun& run : band.shares) {
                EXPECT_NE(run.face, background_rank);
                for (std::size_t k = 0; k < run.count; ++k)
                    total[(run.line - band.first_line) * length + run.first + k] +=
                        band.weights[run.first_weight + k];
            }
            for (std::size_t k = 0; k < total.size(); ++k) {
                const bool is_shared = is_set(band.shared.data(), static_cast<std::uint32_t>(k));
                ASSERT_EQ(total[k], is_shared ? whole_pixel : 0U);
            }
        }
    }
}

TEST(Smoothing, EdgePixelsAreWithinTwoLevelsOfExactAreas) {
    double sum = 0.0;
    std::uint64_t edge_values = 0;
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        ProjectedFaces projected;
        std::vector<Colour> colours;
        for (std::uint64_t k = 0; k < 12; ++k) {
            ProjectedFace face = add_polygon(seed * 100 + k, 25, projected);
            face.colour = static_cast<std::uint16_t>(k);
            projected.faces.push_back(face);
            const std::uint64_t c = random_bits(seed, 50 + k);
            colours.push_back({static_cast<std::uint8_t>(c), static_cast<std::uint8_t>(c >> 8U),
                               static_cast<std::uint8_t>(c >> 16U)});
        }
        std::vector<BandSegments> bands;
        const VideoFrame picture = draw(projected, colours, bands);
        for (std::uint32_t k = 0; k < side * side; ++k) {
            double left = 1.0, red = 0.0, green = 0.0, blue = 0.0;
            bool edge = false;
            for (const ProjectedFace& face : projected.faces) {
                const double area =
                    std::min(left, area_in_pixel(outline_of(projected, face), k % side, k / side));
                edge = edge || (area > 0.0 && area < 1.0);
                red += area * colours[face.colour].red;
                green += area * colours[face.colour].green;
                blue += area * colours[face.colour].blue;
                left -= area;
            }
            const double exact[3] = {red, green, blue};
            for (int c = 0; c < 3 && edge; ++c) {
                sum += std::fabs(exact[c] - static_cast<double>(picture.pixels[k] >> (8 * c) & 0xffU));
                ++edge_values;
            }
        }
    }
    EXPECT_GT(edge_values, 10000U);
    EXPECT_LE(sum / static_cast<double>(edge_values), 2.0);
    RecordProperty("mean_absolute_error_levels", std::to_string(sum / static_cast<double>(edge_values)));
}

TEST(Smoothing, AThinStripeKeepsItsLightWhereverItLies) {
    double least = 1e30, greatest = 0.0;
    for (int step = 0; step < 60; ++step) {
        for (const bool along_lines : {false, true}) {
            ProjectedFaces projected;
            const auto from = static_cast<std::int32_t>(std::floor(256 * (10.0 + 0.1 * step) + 0.5));
            const auto to = static_cast<std::int32_t>(std::floor(256 * (10.3 + 0.1 * step) + 0.5));
            ProjectedFace face;
            face.point_count = 4;
            projected.points =
                along_lines ? std::vector<RasterPoint>{{from, 1024}, {from, 8192}, {to, 8192}, {to, 1024}}
                            : std::vector<RasterPoint>{{1024, from}, {1024, to}, {8192, to}, {8192, from}};
            projected.faces = {face};
            std::vector<BandSegments> bands;
            const VideoFrame picture = draw(projected, {{250, 250, 250}}, bands);
            double light = 0.0;
            for (const std::uint32_t pixel : picture.pixels)
                light += pixel & 0xffU;
            least = std::min(least, light);
            greatest = std::max(greatest, light);
        }
    }
    EXPECT_LE((greatest - least) / least, 0.02);
    EXPECT_NEAR(least, 0.3 * 28 * 250, 0.02 * 0.3 * 28 * 250);
}

TEST(Smoothing, TheSeaLetsNoSkyThrough) {
    const VisualDatabase database = sea_database();
    Configuration configuration;
    configuration.edge_smoothing = true;
    for (const Scan scan : {Scan::horizontal, Scan::vertical}) {
        configuration.raster = {160, 160, scan};
        Machine machine(database, configuration);
        FramePacket packet;
        packet.channels = {channel_at({3, 4, 25}, 33.0)};
        packet.suns = {Vec3f(direction(0.4, radians(30.0)))};
        packet.sky = {1, 0, 1};
        machine.frame(packet);
        const std::vector<std::uint32_t> before = machine.picture(0).pixels;
        packet.sky = {0, 1, 0};
        machine.frame(packet);
        for (std::size_t k = 160 * 80; k < before.size(); ++k) {
            ASSERT_EQ(machine.picture(0).pixels[k], before[k]) << "row " << k / 160;
        }
    }
}

TEST(Smoothing, ThreadsAndScansDoNotMatter) {
    const VisualDatabase database = sea_database();
    std::vector<std::uint32_t> expected;
    for (const std::uint32_t threads : {1U, 2U, 4U}) {
        Configuration configuration;
        configuration.edge_smoothing = true;
        configuration.raster = {200, 200, Scan::horizontal};
        configuration.threads = threads;
        Machine machine(database, configuration);
        FramePacket packet;
        packet.channels = {channel_at({3, 4, 25}, 33.0, -10.0, 14.0)};
        packet.suns = {Vec3f(direction(0.4, radians(30.0)))};
        machine.frame(packet);
        if (expected.empty()) expected = machine.picture(0).pixels;
        EXPECT_EQ(machine.picture(0).pixels, expected) << threads;
    }
}

} // namespace
} // namespace linkdig::ig
