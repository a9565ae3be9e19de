#include "tools/compare/details.h"

#include "tools/compare/report_pictures.h"

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>

#include <algorithm>
#include <array>
#include <vector>

namespace linkdig::compare {
namespace {

constexpr std::uint32_t map_columns = 64;
constexpr std::uint32_t map_rows = 24;
constexpr std::size_t most_culprits = 5;
/// Yee's metric takes seconds at 1024 x 1024 pixels, and more memory than all else: unasked, small pictures get it.
constexpr std::size_t most_perceptual_pixels = 102'400;

char sign_of(float level) {
    struct Step {
        float level;
        char sign;
    };
    constexpr std::array steps{Step{0.0F, ' '}, Step{1.0F, '.'}, Step{4.0F, ':'}, Step{16.0F, '+'},
                               Step{64.0F, 'x'}};
    const auto found = std::ranges::find_if(steps, [&](const Step& step) { return level <= step.level; });
    return found == steps.end() ? '#' : found->sign;
}

OIIO::ImageBuf buffer_of(const Picture& picture) {
    using OIIO::TypeDesc;
    constexpr TypeDesc::BASETYPE types[] = {TypeDesc::UINT8, TypeDesc::UINT16, TypeDesc::UINT32,
                                            TypeDesc::FLOAT};
    const TypeDesc type = types[static_cast<std::size_t>(picture.sample)];
    const OIIO::ImageSpec spec(static_cast<int>(picture.width), static_cast<int>(picture.height),
                               static_cast<int>(picture.channels), type);
    OIIO::ImageBuf buffer(spec);
    buffer.set_pixels(buffer.roi(), type, picture.bytes.data());
    return buffer;
}

} // namespace

std::string character_map(std::span<const float> levels, std::uint32_t width, std::uint32_t height) {
    const std::uint32_t columns = std::min(width, map_columns);
    // A character is about twice as high as it is wide.
    const std::uint32_t fitting =
        std::max(1U, static_cast<std::uint32_t>(std::uint64_t{columns} * height / width / 2));
    const std::uint32_t rows = std::min({height, map_rows, fitting});
    std::vector<float> cells(std::size_t{columns} * rows, 0.0F);
    for (std::uint32_t y = 0; y < height; ++y) {
        const std::size_t row = std::size_t{y} * rows / height;
        for (std::uint32_t x = 0; x < width; ++x) {
            float& cell = cells[row * columns + std::size_t{x} * columns / width];
            cell = std::max(cell, levels[std::size_t{y} * width + x]);
        }
    }
    std::string map;
    for (std::uint32_t row = 0; row < rows; ++row) {
        map += "  |";
        for (std::uint32_t column = 0; column < columns; ++column)
            map += sign_of(cells[std::size_t{row} * columns + column]);
        map += "|\n";
    }
    return map;
}

std::optional<std::uint64_t> perceptual_difference(const Picture& expected, const Picture& actual) {
    if (expected.names_things() || expected.channels < 3) return std::nullopt;
    OIIO::ImageBufAlgo::CompareResults results;
    const OIIO::ImageBuf a = buffer_of(expected);
    const OIIO::ImageBuf b = buffer_of(actual);
    const int failing = OIIO::ImageBufAlgo::compare_Yee(a, b, results);
    return static_cast<std::uint64_t>(std::max(failing, 0));
}

void add_details(const Case& which, const Settings& settings, bool perceptual, FrameResult& frame) {
    if (!frame.expected || !frame.actual) return; // the file has gone since
    const auto lens = lens_of(which, settings.scan, frame);
    const std::vector<float> levels = difference_levels(*frame.expected, *frame.actual, lens->measure);
    frame.details.map = character_map(levels, frame.expected->width, frame.expected->height);
    const Ids none_known;
    frame.details.culprits =
        culprits(levels, frame.expected_ids ? *frame.expected_ids : none_known,
                 frame.actual_ids ? *frame.actual_ids : none_known, settings.expected_frames.database,
                 settings.actual_frames.database, most_culprits);
    if (perceptual && (settings.perceptual || frame.expected->pixels() <= most_perceptual_pixels))
        frame.details.perceptual = perceptual_difference(*frame.expected, *frame.actual);
    if (settings.pictures) add_pictures(levels, frame);
    frame.expected.reset();
    frame.actual.reset();
    frame.expected_ids.reset();
    frame.actual_ids.reset();
}

} // namespace linkdig::compare
