#include "tools/sheet/text.h"

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <fmt/format.h>

#include <stdexcept>

namespace linkdig::tools {
namespace {

constexpr const char* letter_font = "DejaVuSansMono";

OIIO::ROI size_of(const std::string& text, int size_px, const char* font) {
    const OIIO::ROI size = OIIO::ImageBufAlgo::text_size(text, size_px, font);
    if (!size.defined())
        throw std::runtime_error(
            fmt::format("font \"{}\" was not found; it comes with the package fonts-dejavu-core", font));
    return size;
}

/// From letter to letter: the ink of 17 letters is 16 steps wider than that of one.
int letter_step(int size_px) {
    const OIIO::ROI one = size_of("M", size_px, letter_font);
    const OIIO::ROI seventeen = size_of(std::string(17, 'M'), size_px, letter_font);
    return (seventeen.width() - one.width() + 8) / 16;
}

} // namespace

void require_fonts() {
    size_of("M", 16, title_font);
    size_of("M", 16, letter_font);
}

GlyphSheet glyph_sheet(int size_px) {
    std::string all;
    for (int letter = GlyphSheet::first; letter <= GlyphSheet::last; ++letter)
        all += static_cast<char>(letter);
    // A row of nothing above and below the tallest ink: no letter reaches into its neighbour's cell.
    const OIIO::ROI ink = size_of(all, size_px, letter_font);
    const int baseline = 1 - ink.ybegin;
    GlyphSheet sheet;
    sheet.cell_width = letter_step(size_px);
    sheet.cell_height = ink.height() + 2;
    const OIIO::ImageSpec spec(sheet.width(), sheet.height(), 4, OIIO::TypeDesc::UINT8);
    OIIO::ImageBuf image(spec);
    OIIO::ImageBufAlgo::zero(image);
    for (int letter = GlyphSheet::first; letter <= GlyphSheet::last; ++letter) {
        const int index = letter - GlyphSheet::first;
        const int x = index % GlyphSheet::columns * sheet.cell_width;
        const int y = index / GlyphSheet::columns * sheet.cell_height + baseline;
        OIIO::ImageBufAlgo::render_text(image, x, y, std::string(1, static_cast<char>(letter)), size_px,
                                        letter_font, {1.0F, 1.0F, 1.0F, 1.0F});
    }
    sheet.pixels.resize(static_cast<std::size_t>(sheet.width()) * static_cast<std::size_t>(sheet.height()));
    image.get_pixels(image.roi(), OIIO::TypeDesc::UINT8, sheet.pixels.data());
    return sheet;
}

namespace {

/// `share` of 255 of a colour component over what is there.
std::uint32_t blended(std::uint32_t below, std::uint32_t above, std::uint32_t share) {
    std::uint32_t made = 0xFF000000U;
    for (const unsigned component : {0U, 8U, 16U}) {
        const std::uint32_t a = (below >> component) & 0xFFU;
        const std::uint32_t b = (above >> component) & 0xFFU;
        made |= ((a * (255 - share) + b * share + 127) / 255) << component;
    }
    return made;
}

} // namespace

void write_over(ig::VideoFrame& picture, std::string_view text, const GlyphSheet& glyphs) {
    constexpr std::uint32_t margin = 8;
    const auto cell_width = static_cast<std::uint32_t>(glyphs.cell_width);
    const auto cell_height = static_cast<std::uint32_t>(glyphs.cell_height);
    const std::uint32_t ground = cell_height + 2 * margin;
    if (picture.height < ground) return;
    for (std::uint32_t y = picture.height - ground; y < picture.height; ++y)
        for (std::uint32_t x = 0; x < picture.width; ++x)
            picture.pixels[std::size_t{y} * picture.width + x] =
                blended(picture.pixels[std::size_t{y} * picture.width + x], 0x00140E0AU, 150);
    std::uint32_t left = margin;
    for (const char letter : text) {
        if (left + cell_width > picture.width) return;
        const int index = letter - GlyphSheet::first;
        const bool known = letter >= GlyphSheet::first && letter <= GlyphSheet::last;
        for (std::uint32_t y = 0; known && y < cell_height; ++y) {
            for (std::uint32_t x = 0; x < cell_width; ++x) {
                const std::size_t from =
                    (static_cast<std::size_t>(index / GlyphSheet::columns) * cell_height + y) *
                        static_cast<std::size_t>(glyphs.width()) +
                    static_cast<std::size_t>(index % GlyphSheet::columns) * cell_width + x;
                std::uint32_t& to =
                    picture
                        .pixels[std::size_t{picture.height - ground + margin + y} * picture.width + left + x];
                to = blended(to, glyphs.pixels[from], glyphs.pixels[from] >> 24U);
            }
        }
        left += cell_width;
    }
}

} // namespace linkdig::tools
