#include "tools/display/retro_display.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace linkdig::tools {
namespace {

using ig::Raster;
using ig::Scan;
using ig::VideoFrame;

VideoFrame picture_of(const Raster& raster, auto&& level) {
    VideoFrame picture;
    picture.width = raster.width;
    picture.height = raster.height;
    for (std::uint32_t row = 0; row < raster.height; ++row)
        for (std::uint32_t column = 0; column < raster.width; ++column)
            picture.pixels.push_back(0xff000000U | level(column, row) * 0x010101U);
    return picture;
}

double mean(const VideoFrame& picture) {
    double sum = 0.0;
    for (const std::uint32_t pixel : picture.pixels)
        sum += (pixel & 0xffU) + (pixel >> 8U & 0xffU) + (pixel >> 16U & 0xffU);
    return sum / 3.0 / static_cast<double>(picture.pixels.size());
}

/// Mean over the lines field, field + fields, ... of the glass, their middles and borders apart.
double mean_of_lines(const VideoFrame& glass, Scan scan, std::uint32_t first, std::uint32_t step) {
    double sum = 0.0, count = 0.0;
    for (std::uint32_t row = 0; row < glass.height; ++row)
        for (std::uint32_t column = 0; column < glass.width; ++column) {
            if ((scan == Scan::horizontal ? row : column) % step != first) continue;
            sum += glass.pixels[row * glass.width + column] & 0xffU;
            ++count;
        }
    return sum / count;
}

constexpr std::array rasters{Raster{32, 24, Scan::horizontal}, Raster{32, 24, Scan::vertical}};

TEST(RetroDisplay, KeepsTheMeanLuminanceOfAStandingPicture) {
    for (const Raster& raster : rasters) {
        for (const std::uint32_t fields : {1U, 2U}) {
            for (const std::uint32_t level : {0U, 3U, 90U, 200U, 255U}) {
                const VideoFrame picture = picture_of(raster, [&](auto, auto) { return level; });
                RetroDisplay display(raster, fields);
                double last = 0.0;
                for (std::uint32_t k = 0; k < 20 * fields; ++k) {
                    const double shown = mean(display.show(picture, k % fields));
                    if (k >= 19 * fields) last += shown / fields;
                }
                EXPECT_NEAR(last, level, 1.0) << fields;
                EXPECT_NEAR(mean(display.photograph(picture)), level, 1.0);
            }
        }
    }
}

TEST(RetroDisplay, KeepsItWithinEdgesToo) {
    // A bright bar on a dark ground, away from the border.
    for (const Raster& raster : rasters) {
        const VideoFrame picture = picture_of(raster, [](auto column, auto row) {
            return column > 8 && column < 20 && row > 5 && row < 12 ? 230U : 20U;
        });
        RetroDisplay display(raster, 2);
        for (int k = 0; k < 20; ++k)
            display.photograph(picture);
        EXPECT_NEAR(mean(display.photograph(picture)), mean(picture), 1.0);
    }
}

TEST(RetroDisplay, FieldsAlternate) {
    for (const Raster& raster : rasters) {
        const VideoFrame picture = picture_of(raster, [](auto, auto) { return 100U; });
        RetroDisplay display(raster, 2);
        for (std::uint32_t k = 0; k < 20; ++k)
            display.show(picture, k % 2);
        for (const std::uint32_t field : {0U, 1U}) {
            const VideoFrame& glass = display.show(picture, field);
            // Middles of the field's own lines are fresh, those of the other field's have decayed by one field.
            const double fresh = mean_of_lines(glass, raster.scan, 2 * field, 4);
            const double decayed = mean_of_lines(glass, raster.scan, 2 * (1 - field), 4);
            EXPECT_NEAR(decayed / fresh, phosphor_persistence, 0.02);
        }
    }
}

TEST(RetroDisplay, LinesStandOutFromTheirBorders) {
    for (const Raster& raster : rasters) {
        const VideoFrame picture = picture_of(raster, [](auto, auto) { return 100U; });
        RetroDisplay display(raster, 1);
        for (int k = 0; k < 20; ++k)
            display.show(picture, 0);
        const VideoFrame& glass = display.show(picture, 0);
        EXPECT_EQ(glass.width, 2 * raster.width);
        EXPECT_NEAR(mean_of_lines(glass, raster.scan, 0, 2), 100.0 * (1.0 + line_contrast), 1.0);
        EXPECT_NEAR(mean_of_lines(glass, raster.scan, 1, 2), 100.0 * (1.0 - line_contrast), 1.0);
    }
}

TEST(RetroDisplay, APhosphorGlowsOnAndGoesOut) {
    const Raster raster{8, 8, Scan::horizontal};
    RetroDisplay display(raster, 1);
    const VideoFrame bright = picture_of(raster, [](auto, auto) { return 80U; });
    const VideoFrame dark = picture_of(raster, [](auto, auto) { return 0U; });
    for (int k = 0; k < 20; ++k)
        display.show(bright, 0);
    double before = 80.0;
    for (int k = 1; k < 4; ++k) {
        const double shown = mean(display.show(dark, 0));
        EXPECT_NEAR(shown, 80.0 * std::pow(phosphor_persistence, k), 1.5);
        EXPECT_LT(shown, before);
        before = shown;
    }
    for (int k = 0; k < 30; ++k)
        display.show(dark, 0);
    EXPECT_EQ(mean(display.show(dark, 0)), 0.0);
}

TEST(RetroDisplay, IsAPureFunctionOfThePictures) {
    const Raster raster{16, 16, Scan::vertical};
    const VideoFrame picture =
        picture_of(raster, [](auto column, auto row) { return (column * 13 + row * 7) % 256U; });
    RetroDisplay one(raster, 2);
    RetroDisplay other(raster, 2);
    for (std::uint32_t k = 0; k < 7; ++k)
        EXPECT_EQ(one.show(picture, k % 2).pixels, other.show(picture, k % 2).pixels);
}

} // namespace
} // namespace linkdig::tools
