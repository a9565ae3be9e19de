// The inner loop gives the same bytes at every SIMD level, and what the definition says.

#include "ig/simd/simd_level.h"
#include "ig/video/pixel_run.h"

#include "database/model/random.h"
#include "ig/edges/edges.h"
#include "ig/geometry/projected_face.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace linkdig::ig {
namespace {

IntensityPlane random_plane(std::uint64_t seed) {
    const auto bits = [seed](std::uint64_t k) { return static_cast<std::uint32_t>(random_bits(seed, k)); };
    IntensityPlane plane;
    plane.reference_line = static_cast<std::int32_t>(bits(0) % 4096);
    plane.reference_element = static_cast<std::int32_t>(bits(1) % 4096);
    plane.value = bits(2) % (intensity_one + 1);
    // From level to steeper than a sliver's, wrapping round 2^32.
    plane.along = bits(3) >> (seed % 24) | (seed % 2 == 0 ? 0U : 0x80000000U);
    plane.across = bits(4) >> (seed % 20);
    plane.least = static_cast<std::int32_t>(bits(5) % intensity_one);
    plane.greatest = plane.least + static_cast<std::int32_t>(
                                       bits(6) % static_cast<std::uint32_t>(intensity_one + 1 - plane.least));
    return plane;
}

TEST(PixelRun, EveryLevelGivesTheSameBytes) {
    std::vector<std::string> ran;
    for (const std::string& level : simd_levels()) {
        ASSERT_TRUE(use_simd_level(level)) << level;
        ran.push_back(level);
        for (std::uint64_t seed = 0; seed < 500; ++seed) {
            const IntensityPlane plane = random_plane(seed);
            const std::uint64_t c = random_bits(seed, 9);
            const Colour colour{static_cast<std::uint8_t>(c), static_cast<std::uint8_t>(c >> 8U),
                                static_cast<std::uint8_t>(c >> 16U)};
            const auto count = static_cast<std::uint32_t>(seed % 131);
            std::vector<std::uint32_t> pixels(count + 1, 0x12345678U);
            const Segment run{7, 11, static_cast<std::uint16_t>(count)};
            const FaceSegments face{0, 1};
            const FaceShading shading{.plane = plane};
            shade_faces({{&face, 1}, {&run, 1}, {&shading, 1}, {&colour, 1}, {}, {}}, 0,
                        {pixels.data() - 11, 7, 0});
            for (std::uint32_t k = 0; k < count; ++k) {
                const std::int32_t intensity = intensity_at(plane, 7, 11 + static_cast<std::int32_t>(k));
                ASSERT_EQ(pixels[k], shade(colour, intensity)) << level << " seed " << seed << " pixel " << k;
            }
            ASSERT_EQ(pixels[count], 0x12345678U) << level << " wrote past its end";
        }
    }
    EXPECT_TRUE(use_simd_level("best"));
    EXPECT_EQ(ran.back(), "scalar");
    std::string told;
    for (const std::string& level : ran)
        told += " " + level;
    RecordProperty("levels", told);
}

TEST(PixelRun, RefusesALevelThatTheMachineLacks) { EXPECT_FALSE(use_simd_level("AVX9000")); }

TEST(PixelRun, ShadeIsTheProductRoundedToTheNearestLevel) {
    EXPECT_EQ(shade({255, 128, 1}, intensity_one), 0xff0180ffU);
    EXPECT_EQ(shade({255, 128, 1}, 0), 0xff000000U);
    for (int code = 0; code <= 255; ++code) {
        for (std::int32_t intensity = 0; intensity <= intensity_one; intensity += 4099) {
            const double product = code * static_cast<double>(intensity) / intensity_one;
            const auto level =
                static_cast<int>(shade({static_cast<std::uint8_t>(code), 0, 0}, intensity) & 0xffU);
            ASSERT_NEAR(level, product, 0.5 + 1.0 / 128.0) << code << " x " << intensity;
        }
    }
}

} // namespace
} // namespace linkdig::ig
