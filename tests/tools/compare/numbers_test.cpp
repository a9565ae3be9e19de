#include "tools/compare/details.h"
#include "tools/compare/difference.h"
#include "tools/compare/frame_name.h"
#include "tools/compare/histogram.h"
#include "tools/compare/region.h"

#include <gmock/gmock.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>

namespace linkdig::compare {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

template <class Number>
Picture picture_of(std::uint32_t width, std::uint32_t height, std::uint32_t channels, Sample sample,
                   const std::vector<Number>& samples) {
    Picture picture{width, height, channels, sample, "test", {}, {}};
    picture.channel_names.assign(channels, "C");
    picture.bytes.resize(samples.size() * sizeof(Number));
    std::memcpy(picture.bytes.data(), samples.data(), picture.bytes.size());
    return picture;
}

Picture grey(std::uint32_t width, std::uint32_t height, std::vector<std::uint8_t> samples) {
    return picture_of<std::uint8_t>(width, height, 1, Sample::u8, samples);
}

Tolerance tolerance(const std::string& text) {
    const std::string texts[] = {text};
    return parse_tolerance(texts);
}

std::string refusal(const auto& call) {
    try {
        call();
    } catch (const std::invalid_argument& mistake) {
        return mistake.what();
    }
    return "accepted";
}

TEST(CompareNumbers, EqualPicturesHaveNoDifference) {
    const Picture a = grey(2, 2, {1, 2, 3, 4});
    const Difference d = measure(a, a, {});
    EXPECT_EQ(d.differing, 0U);
    EXPECT_EQ(d.counted, 4U);
    EXPECT_EQ(d.largest, 0.0);
    EXPECT_THAT(d.buckets, ElementsAre(0));
}

// Worked by hand: differences 0, 3, 0, 4 over four samples.
TEST(CompareNumbers, FiguresAreThoseOfTheirDefinitions) {
    const Difference d = measure(grey(2, 2, {10, 20, 30, 40}), grey(2, 2, {10, 23, 30, 36}), {});
    EXPECT_EQ(d.differing, 2U);
    EXPECT_EQ(d.largest, 4.0);
    EXPECT_DOUBLE_EQ(d.mean, 7.0 / 4.0);
    EXPECT_DOUBLE_EQ(d.rms, 2.5);
    EXPECT_NEAR(d.psnr_db, 20.0 * std::log10(102.0), 1e-12);
    EXPECT_DOUBLE_EQ(percent(d), 50.0);
    EXPECT_EQ(d.first, (Place{1, 0, 0}));
    EXPECT_EQ(d.worst, (Place{1, 1, 0}));
    EXPECT_EQ(d.histogram[3], 1U);
    EXPECT_EQ(d.histogram[4], 1U);
    EXPECT_EQ(d.histogram[0], 2U);
}

TEST(CompareNumbers, TheFirstPixelFollowsTheScan) {
    const Picture a = grey(3, 2, {0, 0, 0, 0, 0, 0});
    const Picture b = grey(3, 2, {0, 0, 9, 9, 0, 0});
    Measure how;
    EXPECT_EQ(measure(a, b, how).first, (Place{2, 0, 0}));
    how.scan = ig::Scan::vertical;
    EXPECT_EQ(measure(a, b, how).first, (Place{0, 1, 0}));
}

TEST(CompareNumbers, DepthsAreComparedAsLevels) {
    const Picture eight = grey(2, 1, {128, 255});
    const auto sixteen = picture_of<std::uint16_t>(2, 1, 1, Sample::u16, {128 * 257, 65535});
    const auto floats = picture_of<float>(2, 1, 1, Sample::f32, {0.5F, 1.0F});
    EXPECT_EQ(measure(eight, sixteen, {}).differing, 0U);
    EXPECT_DOUBLE_EQ(measure(eight, floats, {}).largest, 0.5);
    const auto off = picture_of<std::uint16_t>(2, 1, 1, Sample::u16, {128 * 257 + 1, 65535});
    EXPECT_EQ(measure(eight, off, {}).differing, 1U);
}

TEST(CompareNumbers, WhatIsNoNumberDiffersWithoutBound) {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    constexpr float infinite = std::numeric_limits<float>::infinity();
    const auto a = picture_of<float>(3, 1, 1, Sample::f32, {nan, nan, infinite});
    const auto b = picture_of<float>(3, 1, 1, Sample::f32, {nan, 0.5F, infinite});
    const Difference d = measure(a, b, {});
    EXPECT_EQ(d.differing, 1U);
    EXPECT_TRUE(std::isinf(d.largest));
    EXPECT_EQ(d.histogram[beyond_levels], 1U);
}

TEST(CompareNumbers, NumbersThatNameThingsAreEqualOrNot) {
    const auto a = picture_of<std::uint32_t>(2, 1, 1, Sample::u32, {7, 8});
    const auto b = picture_of<std::uint32_t>(2, 1, 1, Sample::u32, {7, 9});
    const Difference d = measure(a, b, {.tolerance = tolerance("<=5:*")});
    EXPECT_THAT(d.buckets, ElementsAre(0, 1));
}

TEST(CompareTolerance, BucketsTakePixelsAboveTheOneBefore) {
    const Picture a = grey(5, 1, {0, 0, 0, 0, 0});
    const Picture b = grey(5, 1, {0, 1, 1, 5, 6});
    const Tolerance t = tolerance("<=1:*, <=5:100");
    const Difference d = measure(a, b, {.tolerance = t});
    EXPECT_THAT(d.buckets, ElementsAre(2, 1, 1));
    EXPECT_FALSE(is_within(t, d.buckets));
    EXPECT_TRUE(
        is_within(tolerance("<=1:2,<=6:2"), measure(a, b, {.tolerance = tolerance("<=1:2,<=6:2")}).buckets));
    EXPECT_FALSE(
        is_within(tolerance("<=1:1,<=6:2"), measure(a, b, {.tolerance = tolerance("<=1:1,<=6:2")}).buckets));
}

TEST(CompareTolerance, BetterThanDeclaredIsTold) {
    Declared declared(tolerance("<=1:*,<=5:10-20"));
    declared.take(std::vector<std::uint64_t>{3, 9, 0});
    EXPECT_THAT(declared.better(),
                HasSubstr("<=5:10-20 expects a frame with at least 10 such pixels, the worst has 9"));
    declared.take(std::vector<std::uint64_t>{0, 10, 0});
    EXPECT_EQ(declared.better(), "");
    EXPECT_NE(Declared(tolerance("<=1:*")).better(), "");
    EXPECT_EQ(Declared(tolerance("<=1:0-*")).better(), "");
}

TEST(CompareTolerance, MistakesAreNamed) {
    for (const char* text :
         {"", "1:2", "<=1", "<=1:", "<=-1:2", "<=0:*", "<=x:1", "<=1:5-2", "<=1:0", "<=1:2,", "<=nan:*"})
        EXPECT_THAT(refusal([&] { tolerance(text); }), HasSubstr("is no tolerance; expected <=LEVELS:COUNT"))
            << text;
    EXPECT_THAT(refusal([&] { tolerance("<=5:1,<=5:2"); }), HasSubstr("above those of the one before"));
    EXPECT_EQ(tolerance_text(tolerance("<=0.5:*, <=2:10-20,<=3:0-*")), "<=0.5:*, <=2:10-20, <=3:0-*");
}

TEST(CompareRegions, RectanglesAndMaskDecideWhatCounts) {
    Regions regions;
    regions.include = {{1, 0, 3, 9}};
    regions.ignore = {{2, 0, 1, 1}};
    EXPECT_THAT(counted_pixels(regions, 4, 2), ElementsAre(0, 1, 0, 1, 0, 1, 1, 1));
    regions.mask = grey(4, 2, {255, 255, 255, 0, 255, 0, 255, 255});
    EXPECT_THAT(counted_pixels(regions, 4, 2), ElementsAre(0, 1, 0, 0, 0, 0, 1, 1));
    EXPECT_THAT(mask_mistake(regions, 5, 2), HasSubstr("4 x 2 pixels; expected the frame's 5 x 2"));
    EXPECT_TRUE(counted_pixels({}, 4, 2).empty());
}

TEST(CompareRegions, IgnoredPixelsAreCountedApart) {
    const std::vector<std::uint8_t> counted{1, 0, 1, 1};
    const Difference d = measure(grey(4, 1, {0, 0, 0, 0}), grey(4, 1, {0, 9, 9, 0}), {.counted = counted});
    EXPECT_EQ(d.counted, 3U);
    EXPECT_EQ(d.differing, 1U);
    EXPECT_EQ(d.ignored, 1U);
}

TEST(CompareRegions, MistakesAreNamed) {
    for (const char* text :
         {"", "1,2,3", "1,2,3,0", "1,2,3,4,5", "1,2,3,4,", "-1,2,3,4", "a,b,c,d", "1 ,2,3,4"})
        EXPECT_THAT(refusal([&] { parse_rectangle(text); }), HasSubstr("expected X,Y,WIDTH,HEIGHT")) << text;
    for (const char* text : {"", "1,2", "1,2,256", "1,2,3,4", "1,2,nan"})
        EXPECT_THAT(refusal([&] { parse_colour(text); }), HasSubstr("expected R,G,B")) << text;
}

TEST(CompareNames, NumbersAndPlanesOfFrames) {
    struct Sample {
        const char* file;
        const char* series;
        std::optional<std::uint64_t> number;
        const char* plane;
        const char* prefix;
    };
    for (const Sample& s :
         {Sample{"colour_000010.png", "colour", 10, "", ""},
          Sample{"list_000010.exr", "list", 10, "list", ""}, Sample{"frame0001.png", "frame", 1, "", "frame"},
          Sample{"shot.12.exr", "shot", 12, "", "shot"}, Sample{"0007.tif", "", 7, "", ""},
          Sample{"contact.png", "contact", {}, "", "contact"},
          Sample{"cab_face_3.exr", "cab_face", 3, "face", "cab_"},
          Sample{"surface_3.exr", "surface", 3, "", "surface"},
          Sample{"channel_2_30.png", "channel_2", 30, "", "channel_2"},
          Sample{"99999999999999999999999.png", "99999999999999999999999", {}, "", "99999999999999999999999"},
          Sample{"caf\xc3\xa9 1.png", "caf\xc3\xa9", 1, "", "caf\xc3\xa9"}}) {
        const FrameName name = frame_name(s.file);
        EXPECT_EQ(name.series, s.series) << s.file;
        EXPECT_EQ(name.number, s.number) << s.file;
        EXPECT_EQ(name.plane, s.plane) << s.file;
        EXPECT_EQ(name.prefix, s.prefix) << s.file;
    }
    EXPECT_TRUE(is_picture_file("A.PNG"));
    EXPECT_FALSE(is_picture_file("notes.txt"));
    EXPECT_FALSE(is_picture_file("png"));
}

TEST(CompareMap, ShowsWhereAndHowMuch) {
    std::vector<float> levels(8 * 4, 0.0F);
    levels[0] = 1.0F;
    levels[7] = 200.0F;
    levels[4 * 8 - 1] = 20.0F;
    EXPECT_EQ(character_map(levels, 8, 4), "  |.      #|\n  |       x|\n");
    EXPECT_EQ(character_map(std::vector<float>{3.0F}, 1, 1), "  |:|\n");
    EXPECT_EQ(character_map(std::vector<float>(1000, 0.0F), 1000, 1).size(), 64U + 5U);
}

TEST(CompareHistogram, BarsDoubleAndCoverEveryLevel) {
    std::array<std::uint64_t, beyond_levels + 1> histogram{};
    histogram.fill(1);
    const auto bars = bars_of(histogram);
    std::uint64_t pixels = 0;
    for (const HistogramBar& bar : bars)
        pixels += bar.pixels;
    EXPECT_EQ(pixels, 256U);
    EXPECT_EQ(bars[2].levels, "3 to 4");
    EXPECT_EQ(bars[bars.size() - 2].levels, "129 to 255");
}

} // namespace
} // namespace linkdig::compare
