#include "tests/tools/pictures.h"
#include "tools/sheet/contact_sheet.h"
#include "tools/sheet/text.h"

#include <OpenImageIO/imagebuf.h>
#include <gmock/gmock.h>

#include <algorithm>

namespace linkdig::tools {
namespace {

TEST(SheetFrames, TwelveOfManyFromFirstToLast) {
    EXPECT_THAT(sheet_frames(600),
                testing::ElementsAre(0, 54, 108, 163, 217, 272, 326, 381, 435, 490, 544, 599));
    EXPECT_THAT(sheet_frames(12), testing::ElementsAre(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11));
}

TEST(SheetFrames, FewFramesShowTwice) {
    EXPECT_THAT(sheet_frames(1), testing::Each(0U));
    EXPECT_THAT(sheet_frames(0), testing::Each(0U));
    EXPECT_EQ(sheet_frames(2).back(), 1U);
}

ig::VideoFrame plain(std::uint32_t width, std::uint32_t height, std::uint32_t pixel) {
    return {.width = width,
            .height = height,
            .pixels = std::vector<std::uint32_t>(std::size_t{width} * height, pixel),
            .intensity = {},
            .rank = {}};
}

TEST(ContactSheet, EachPictureStandsInItsPlace) {
    const TemporaryFolder folder;
    ContactSheet sheet("heading", 100, 80);
    for (std::uint32_t place = 0; place < sheet_pictures; ++place)
        sheet.place(place, plain(100, 80, 0xFF000000U | (10 + 20 * place)), "");
    sheet.write(folder.file("contact.png"));
    const OIIO::ImageBuf read(folder.file("contact.png"));
    ASSERT_GE(read.spec().width, 400);
    ASSERT_GE(read.spec().height, 240);
    // Down a column the red rises by 80 from row to row, along a row by 20.
    std::vector<int> reds;
    for (int y = 0; y < read.spec().height; ++y) {
        for (int x = 0; x < read.spec().width; ++x) {
            const int red = static_cast<int>(std::lround(read.getchannel(x, y, 0, 0) * 255));
            if (read.getchannel(x, y, 0, 1) == 0.0F &&
                (reds.empty() || std::ranges::find(reds, red) == reds.end()))
                reds.push_back(red);
        }
    }
    EXPECT_THAT(reds, testing::ElementsAre(10, 30, 50, 70, 90, 110, 130, 150, 170, 190, 210, 230));
}

TEST(ContactSheet, LargePicturesAreScaledToTheirMean) {
    const TemporaryFolder folder;
    ContactSheet sheet("", 768, 768);
    ig::VideoFrame stripes = plain(768, 768, 0xFF000000U);
    for (std::size_t pixel = 0; pixel < stripes.pixels.size(); pixel += 2)
        stripes.pixels[pixel] = 0xFFFFFFFFU;
    sheet.place(0, stripes, "");
    sheet.write(folder.file("contact.png"));
    const OIIO::ImageBuf read(folder.file("contact.png"));
    EXPECT_NEAR(read.getchannel(200, 200, 0, 1), 0.5, 0.02);
}

TEST(ContactSheet, TitlesAreDrawn) {
    const TemporaryFolder folder;
    for (const bool titled : {false, true}) {
        ContactSheet sheet("", 100, 80);
        sheet.place(0, plain(100, 80, 0xFF000000U), titled ? "0.0 s" : "");
        sheet.write(folder.file(titled ? "titled.png" : "bare.png"));
    }
    const OIIO::ImageBuf titled(folder.file("titled.png"));
    const OIIO::ImageBuf bare(folder.file("bare.png"));
    int different = 0;
    for (int y = 0; y < bare.spec().height; ++y)
        for (int x = 0; x < bare.spec().width; ++x)
            different += titled.getchannel(x, y, 0, 0) != bare.getchannel(x, y, 0, 0) ? 1 : 0;
    EXPECT_GT(different, 40);
}

/// Pixels of some of a letter's rows that are more than half there.
int ink(const GlyphSheet& sheet, char letter, int first_row, int end_row) {
    const int index = letter - GlyphSheet::first;
    int count = 0;
    for (int y = first_row; y < end_row; ++y) {
        for (int x = 0; x < sheet.cell_width; ++x) {
            const int row = index / GlyphSheet::columns * sheet.cell_height + y;
            const int column = index % GlyphSheet::columns * sheet.cell_width + x;
            const std::uint32_t pixel = sheet.pixels[static_cast<std::size_t>(row * sheet.width() + column)];
            count += (pixel >> 24U) > 127 ? 1 : 0;
        }
    }
    return count;
}
int ink(const GlyphSheet& sheet, char letter) { return ink(sheet, letter, 0, sheet.cell_height); }

TEST(GlyphSheet, EveryLetterHasInkAndSpaceHasNone) {
    const GlyphSheet sheet = glyph_sheet(16);
    EXPECT_EQ(ink(sheet, ' '), 0);
    for (char letter = '!'; letter <= '~'; ++letter)
        EXPECT_GT(ink(sheet, letter), 0) << letter;
    EXPECT_GT(ink(sheet, 'M'), ink(sheet, '.'));
    EXPECT_GT(ink(sheet, '@'), ink(sheet, '-'));
}

TEST(GlyphSheet, NoLetterReachesIntoTheCellAboveOrBelow) {
    for (const int size_px : {8, 15, 16, 40}) {
        const GlyphSheet sheet = glyph_sheet(size_px);
        for (char letter = ' '; letter <= '~'; ++letter) {
            EXPECT_EQ(ink(sheet, letter, 0, 1), 0) << letter << ' ' << size_px;
            EXPECT_EQ(ink(sheet, letter, sheet.cell_height - 1, sheet.cell_height), 0)
                << letter << ' ' << size_px;
        }
    }
}

} // namespace
} // namespace linkdig::tools
