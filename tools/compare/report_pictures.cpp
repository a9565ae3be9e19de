#include "tools/compare/report_pictures.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace linkdig::compare {
namespace {

/// Differences below this share of white are lifted to it: one level must be seen beside two hundred.
constexpr double least_brightness = 40.0;

std::vector<std::uint8_t> encode(const std::vector<std::uint8_t>& samples, std::uint32_t width,
                                 std::uint32_t height, std::uint32_t channels) {
    OIIO::ImageSpec spec(static_cast<int>(width), static_cast<int>(height), static_cast<int>(channels),
                         OIIO::TypeDesc::UINT8);
    spec.attribute("DateTime", "1979:01:01 00:00:00"); // else the time of writing
    std::vector<std::uint8_t> bytes;
    OIIO::Filesystem::IOVecOutput memory(bytes);
    const auto output = OIIO::ImageOutput::create("report.png", &memory);
    if (!output || !output->open("report.png", spec) ||
        !output->write_image(OIIO::TypeDesc::UINT8, samples.data()) || !output->close())
        throw std::runtime_error(fmt::format("a picture of the report cannot be made: {}",
                                             output ? output->geterror() : OIIO::geterror()));
    return bytes;
}

std::uint8_t byte_of(double level) {
    return static_cast<std::uint8_t>(std::isnan(level) ? 0.0
                                                       : std::clamp(std::floor(level + 0.5), 0.0, 255.0));
}

/// Neighbouring numbers get colours far apart; equal numbers the same one.
void colour_of_number(double number, std::uint8_t* rgb) {
    const auto hash = static_cast<std::uint32_t>(number) * 2654435761U;
    for (unsigned k = 0; k < 3; ++k)
        rgb[k] = static_cast<std::uint8_t>(64 + (hash >> (8 * k + 4) & 0xffU) * 3 / 4);
}

} // namespace

std::vector<std::uint8_t> browser_png(const Picture& picture) {
    const bool grey = !picture.names_things() && picture.channels < 3;
    const std::uint32_t channels = grey ? 1 : 3;
    std::vector<std::uint8_t> samples(picture.pixels() * channels);
    std::vector<double> levels(std::size_t{picture.width} * picture.channels);
    std::uint8_t* to = samples.data();
    for (std::uint32_t row = 0; row < picture.height; ++row) {
        row_levels(picture, row, levels.data());
        for (std::uint32_t x = 0; x < picture.width; ++x, to += channels) {
            const double* pixel = &levels[std::size_t{x} * picture.channels];
            if (picture.names_things())
                colour_of_number(*pixel, to);
            else
                std::transform(pixel, pixel + channels, to, byte_of);
        }
    }
    return encode(samples, picture.width, picture.height, channels);
}

std::vector<std::uint8_t> difference_png(std::span<const float> levels, std::uint32_t width,
                                         std::uint32_t height, double gain) {
    std::vector<std::uint8_t> samples(levels.size());
    std::ranges::transform(levels, samples.begin(), [&](float level) {
        return level == 0.0F ? std::uint8_t{0}
                             : byte_of(least_brightness + static_cast<double>(level) * gain *
                                                              (255.0 - least_brightness) / 255.0);
    });
    return encode(samples, width, height, 1);
}

void add_pictures(std::span<const float> levels, FrameResult& frame) {
    const double largest = frame.difference.largest;
    frame.details.gain = std::isfinite(largest) && largest > 0.0 ? 255.0 / largest : 1.0;
    frame.details.expected_png = browser_png(*frame.expected);
    frame.details.actual_png = browser_png(*frame.actual);
    frame.details.difference_png =
        difference_png(levels, frame.expected->width, frame.expected->height, frame.details.gain);
}

} // namespace linkdig::compare
