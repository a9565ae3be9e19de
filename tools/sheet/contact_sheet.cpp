#include "tools/sheet/contact_sheet.h"

#include "ig/sink/image_file.h"
#include "tools/sheet/text.h"

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>

#include <algorithm>
#include <cassert>

namespace linkdig::tools {
namespace {

// Pixels. Pictures are scaled down to this width, never up.
constexpr std::uint32_t widest_picture = 384;
constexpr int gap = 12;
constexpr int heading_height = 48;
constexpr int title_height = 30;
constexpr float paper[4] = {0.10F, 0.11F, 0.13F, 1.0F};
constexpr float heading_ink[4] = {0.96F, 0.96F, 0.94F, 1.0F};
constexpr float title_ink[4] = {0.78F, 0.80F, 0.82F, 1.0F};

OIIO::ROI sheet_area(int picture_width, int picture_height, int rows) {
    const int columns = sheet_columns;
    return {0, columns * (picture_width + gap) + gap,
            0, heading_height + rows * (picture_height + title_height + gap),
            0, 1,
            0, 4};
}

} // namespace

struct ContactSheet::State {
    int picture_width = 0;
    int picture_height = 0;
    std::uint32_t pictures = 0;
    OIIO::ImageBuf page;
};

std::array<std::uint64_t, sheet_pictures> sheet_frames(std::uint64_t frames) {
    std::array<std::uint64_t, sheet_pictures> chosen{};
    const std::uint64_t last = frames == 0 ? 0 : frames - 1;
    for (std::uint64_t place = 0; place < sheet_pictures; ++place)
        chosen[place] = place * last / (sheet_pictures - 1);
    return chosen;
}

ContactSheet::ContactSheet(const std::string& heading, std::uint32_t width, std::uint32_t height,
                           std::uint32_t rows)
    : state_(std::make_unique<State>()) {
    assert(width > 0 && height > 0 && rows > 0);
    state_->pictures = sheet_columns * rows;
    const std::uint32_t shown = std::min(width, widest_picture);
    state_->picture_width = static_cast<int>(shown);
    state_->picture_height = std::max(1, static_cast<int>(height * shown / width));
    const OIIO::ROI area = sheet_area(state_->picture_width, state_->picture_height, static_cast<int>(rows));
    state_->page.reset(OIIO::ImageSpec(area, OIIO::TypeDesc::UINT8));
    OIIO::ImageBufAlgo::fill(state_->page, paper);
    OIIO::ImageBufAlgo::render_text(state_->page, gap, 32, heading, 22, title_font, heading_ink);
}

ContactSheet::~ContactSheet() = default;

void ContactSheet::place(std::uint32_t place, const ig::VideoFrame& picture, const std::string& title) {
    assert(place < state_->pictures);
    const int x = gap + static_cast<int>(place % sheet_columns) * (state_->picture_width + gap);
    const int y = heading_height +
                  static_cast<int>(place / sheet_columns) * (state_->picture_height + title_height + gap);
    const OIIO::ImageSpec spec(static_cast<int>(picture.width), static_cast<int>(picture.height), 4,
                               OIIO::TypeDesc::UINT8);
    // ImageBuf only reads: its interface has no buffer of constants in this version.
    const OIIO::ImageBuf source(spec, const_cast<std::uint32_t*>(picture.pixels.data()));
    const OIIO::ROI shown(0, state_->picture_width, 0, state_->picture_height, 0, 1, 0, 4);
    const OIIO::ImageBuf small = OIIO::ImageBufAlgo::resize(source, "box", 0.0F, shown);
    OIIO::ImageBufAlgo::paste(state_->page, x, y, 0, 0, small);
    OIIO::ImageBufAlgo::render_text(state_->page, x, y + state_->picture_height + 19, title, 15, title_font,
                                    title_ink);
}

void ContactSheet::write(const std::string& path) const {
    ig::VideoFrame page;
    page.width = static_cast<std::uint32_t>(state_->page.spec().width);
    page.height = static_cast<std::uint32_t>(state_->page.spec().height);
    page.pixels.resize(std::size_t{page.width} * page.height);
    state_->page.get_pixels(state_->page.roi(), OIIO::TypeDesc::UINT8, page.pixels.data());
    ig::write_png(path, page);
}

} // namespace linkdig::tools
