/// The machine's picture against two second opinions, on scenes made to be hard.

#include "ig/simd/simd_level.h"
#include "ig/video/pixel_run.h"
#include "tests/ig/random_scene.h"
#include "tests/ig/random_scene_stages.h"
#include "tests/support/painter.h"
#include "tests/support/picture_comparison.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace linkdig::ig {
namespace {

/// Rasters of all awkward sizes: a pixel, a line, widths about the 64 elements of a mask's word, lines about
/// a band's 32.
const Raster rasters[] = {
    {97, 75, Scan::horizontal}, {97, 75, Scan::vertical}, {64, 32, Scan::horizontal},
    {65, 33, Scan::vertical},   {1, 1, Scan::horizontal}, {1, 50, Scan::vertical},
    {130, 1, Scan::horizontal}, {63, 64, Scan::vertical}, {200, 150, Scan::horizontal},
};

std::string name_of(const Raster& raster) {
    return std::to_string(raster.width) + " x " + std::to_string(raster.height) +
           (raster.scan == Scan::vertical ? " vertical" : " horizontal");
}

/// One face of the given points and intensities on a raster of 32 x 32.
Scene single(std::vector<RasterPoint> points, std::vector<std::int32_t> intensities, Scan scan) {
    RandomStream random(1);
    Scene scene = empty_scene(random, {32, 32, scan});
    add_face(scene, random, std::move(points), intensities);
    return scene;
}

TEST(PainterAgainstScanline, no_faces_show_the_background) {
    RandomStream random(1);
    const Scene scene = empty_scene(random, {70, 40, Scan::horizontal});
    const Drawn drawn = draw(scene);
    EXPECT_EQ(std::count(drawn.picture.pixels.begin(), drawn.picture.pixels.end(), scene.packed_background()),
              70 * 40);
    expect_agreement(scene);
}

TEST(PainterAgainstScanline, degenerate_faces) {
    constexpr std::int32_t guard = greatest_coordinate;
    const std::vector<std::int32_t> rise{0, intensity_one / 2, intensity_one};
    const std::vector<std::vector<RasterPoint>> shapes{
        {{128, 128}, {128, 128}, {128, 128}},                // a point on a centre
        {{128, 128}, {128, 4000}, {128, 2000}},              // along a line's centre
        {{128, 128}, {4000, 128}, {2000, 128}},              // across, through centres
        {{0, 0}, {4096, 4096}, {8192, 8192}},                // a diagonal through centres
        {{127, 127}, {127, 129}, {129, 128}},                // about one centre
        {{128, 128}, {128, 129}, {129, 128}},                // one 1/256 pixel, its corner on a centre
        {{129, 129}, {129, 300}, {300, 129}},                // between centres
        {{-guard, -guard}, {-guard, guard}, {guard, guard}}, // the guard band's border
        {{-guard, guard}, {guard, guard}, {guard, -guard}},  // the other half
        {{0, 0}, {1, guard}, {2, -guard}},                   // a sliver from guard to guard
        {{128, -guard}, {384, guard}, {640, guard}},         // nearly along the lines
        {{-guard, 4096}, {guard, 4095}, {guard, 4097}},      // nearly across
    };
    for (const Scan scan : {Scan::horizontal, Scan::vertical})
        for (std::size_t i = 0; i < shapes.size(); ++i) {
            SCOPED_TRACE("shape " + std::to_string(i));
            expect_agreement(single(shapes[i], rise, scan));
            expect_agreement(single(shapes[i], {}, scan));
        }
}

TEST(PainterAgainstScanline, guard_rectangle_covers_every_pixel) {
    constexpr std::int32_t guard = greatest_coordinate;
    const Scene scene =
        single({{-guard, -guard}, {-guard, guard}, {guard, guard}, {guard, -guard}}, {}, Scan::horizontal);
    const Drawn drawn = draw(scene);
    EXPECT_EQ(std::count(drawn.picture.rank.begin(), drawn.picture.rank.end(), 0), 32 * 32);
}

TEST(PainterAgainstScanline, random_scenes) {
    std::uint64_t seed = 0;
    for (const Raster& raster : rasters)
        for (int i = 0; i < 12; ++i) {
            ++seed;
            SCOPED_TRACE("seed " + std::to_string(seed) + ", " + name_of(raster));
            expect_agreement(random_scene(seed, raster, 80));
            if (HasFailure()) return;
        }
}

TEST(PainterAgainstScanline, random_scenes_on_a_large_raster) {
    for (const std::uint64_t seed : {1001U, 1002U}) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        expect_agreement(random_scene(seed, {max_raster_side, 40, Scan::horizontal}, 150));
        expect_agreement(random_scene(seed, {40, max_raster_side, Scan::horizontal}, 150));
        expect_agreement(random_scene(seed, {max_raster_side, 40, Scan::vertical}, 150));
    }
}

/// The claim of ig/edges/edge.h: 4096 steps of a rounded slope decide every pixel as exact arithmetic does.
TEST(PainterAgainstScanline, near_misses_of_pixel_centres) {
    const Raster raster{64, max_raster_side, Scan::horizontal};
    const Scene all = near_miss_scene(5, raster, 120);
    for (std::size_t face = 0; face < all.projected.faces.size(); ++face) {
        SCOPED_TRACE("face " + std::to_string(face));
        Scene one = all;
        one.projected.faces = {all.projected.faces[face]};
        const Drawn drawn = draw(one);
        EXPECT_TRUE(looped(one, drawn.edges).rank == drawn.picture.rank);
        if (face % 8 == 0) expect_agreement(one); // the painter takes its time
    }
}

TEST(PainterAgainstScanline, one_face_at_a_time) {
    for (std::uint64_t seed = 1; seed <= 400; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        expect_agreement(random_scene(seed, rasters[seed % 2], 1));
        if (HasFailure()) return;
    }
}

TEST(PainterAgainstScanline, threads_do_not_change_a_byte) {
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        const Scene scene = random_scene(seed, {300, 200, seed % 2 ? Scan::vertical : Scan::horizontal}, 200);
        const VideoFrame one = draw(scene, 1).picture;
        for (const std::uint32_t threads : {2U, 4U}) {
            const VideoFrame many = draw(scene, threads).picture;
            EXPECT_TRUE(one.pixels == many.pixels) << threads << " threads";
            EXPECT_TRUE(one.rank == many.rank) << threads << " threads";
            EXPECT_TRUE(one.intensity == many.intensity) << threads << " threads";
        }
    }
}

TEST(PainterAgainstScanline, simd_levels_do_not_change_a_byte) {
    const std::vector<std::string> levels = simd_levels();
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        const Scene scene = random_scene(seed, {301, 203, seed % 2 ? Scan::vertical : Scan::horizontal}, 150);
        const Drawn drawn = draw(scene);
        const VideoFrame loop = looped(scene, drawn.edges);
        for (const std::string& level : levels) {
            ASSERT_TRUE(use_simd_level(level)) << level;
            EXPECT_TRUE(draw(scene).picture.pixels == loop.pixels) << level << ", seed " << seed;
        }
        ASSERT_TRUE(use_simd_level("best"));
    }
    EXPECT_FALSE(use_simd_level("no such level"));
}

/// Every element in exactly one segment or in the background, the contract of ig/scanline/segment.h.
TEST(PainterAgainstScanline, every_element_is_written_once) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const Scene scene = random_scene(seed, {150, 100, Scan::horizontal}, 150);
        std::vector<int> writes(150 * 100, 0);
        for (const BandSegments& band : draw(scene).bands)
            for (const SegmentList* list : {&band.segments, &band.background})
                for (const Segment& s : *list)
                    for (std::uint32_t e = s.first; e < std::uint32_t{s.first} + s.count; ++e)
                        ++writes.at(s.line * 150U + e);
        EXPECT_EQ(std::count(writes.begin(), writes.end(), 1), 150 * 100) << "seed " << seed;
    }
}

/// The second opinions against an answer known beforehand, so that they cannot share an emptiness.
TEST(Painter, known_answers) {
    // A square from pixel centre to pixel centre owns its low border and not its high one.
    const Scene square = single({{128, 128}, {128, 1152}, {1152, 1152}, {1152, 128}}, {}, Scan::horizontal);
    const VideoFrame frame = painted(square);
    for (std::uint32_t row = 0; row < 32; ++row)
        for (std::uint32_t column = 0; column < 32; ++column)
            EXPECT_EQ(frame.rank[row * 32 + column], row < 4 && column < 4 ? 0 : none)
                << row << ' ' << column;
    EXPECT_EQ(frame.rank, looped(square, draw(square).edges).rank);
    // Intensity is 0 at the left corner column and 1 at the right one, linear between.
    const IntensityTriangle ramp{
        .line = {128, 128, 8320}, .element = {128, 8320, 128}, .intensity = {0, intensity_one, 0}};
    EXPECT_EQ(support::gouraud(ramp, 0, 0), 0);
    EXPECT_EQ(support::gouraud(ramp, 0, 16), intensity_one / 2);
    EXPECT_EQ(support::gouraud(ramp, 8, 16), intensity_one / 2);
    EXPECT_EQ(support::gouraud(ramp, 0, 32), intensity_one);
    EXPECT_EQ(support::gouraud(ramp, 0, 40), intensity_one); // beyond: the corners' range
    for (int code = 0; code < 256; ++code) {
        const Colour grey{static_cast<std::uint8_t>(code), 0, 255};
        EXPECT_EQ(support::shaded(grey, intensity_one), support::packed(grey.red, 0, 255));
        EXPECT_EQ(support::shaded_with_15_bits(grey, intensity_one), support::packed(grey.red, 0, 255));
        EXPECT_EQ(support::shaded_with_15_bits(grey, 0), support::packed(0, 0, 0));
    }
}

TEST(Painter, comparison_tells_what_differs) {
    const Scene scene = single({{0, 0}, {0, 4096}, {4096, 0}}, {}, Scan::horizontal);
    const VideoFrame frame = painted(scene);
    EXPECT_EQ(support::compare(frame, frame).explanation, "");
    VideoFrame other = frame;
    other.pixels[33] ^= 0x0200U;
    other.rank[70] = 5;
    const support::PictureDifference d = support::compare(frame, other);
    EXPECT_EQ(d.pixels, 2U);
    EXPECT_EQ(d.ranks, 1U);
    EXPECT_EQ(d.worst_level, 2U);
    EXPECT_NE(d.explanation.find("worst at column 6 row 2"), std::string::npos) << d.explanation;
    EXPECT_NE(d.explanation.find("| +   "), std::string::npos) << d.explanation;
}

} // namespace
} // namespace linkdig::ig
