#include "tools/display/retro_display.h"

#include <algorithm>
#include <cassert>
#include <functional>
#include <utility>

namespace linkdig::tools {
namespace {

constexpr std::uint32_t whole = 256; ///< a level
constexpr std::uint32_t brightest = 255 * whole;
constexpr auto released = static_cast<std::uint32_t>((1.0 - phosphor_persistence) * whole + 0.5);
constexpr auto middle_gain = static_cast<std::uint32_t>((1.0 + line_contrast) * whole + 0.5);

/// A line's light in two halves: its middle, and what is left for its two borders.
struct Halves {
    std::uint32_t middle;
    std::uint32_t border;
};
Halves halves(std::uint32_t light) {
    const std::uint32_t middle = std::min(brightest, light * middle_gain / whole);
    return {middle, 2 * light - middle};
}

std::uint32_t levels(std::uint32_t red, std::uint32_t green, std::uint32_t blue) {
    const auto level = [](std::uint32_t light) { return std::min(255U, (light + whole / 2) / whole); };
    return level(red) | level(green) << 8U | level(blue) << 16U | 0xff000000U;
}

} // namespace

RetroDisplay::RetroDisplay(const ig::Raster& raster, std::uint32_t fields)
    : raster_(raster), fields_(std::max(1U, fields)) {
    const std::size_t components = 3 * std::size_t{raster.width} * raster.height;
    held_.assign(components, 0);
    emitted_.assign(components, 0);
    for (LineLight& light : line_light_) {
        light.middle.assign(6 * std::size_t{raster.elements()}, 0);
        light.border = light.middle;
    }
    glass_.width = display_scale * raster.width;
    glass_.height = display_scale * raster.height;
    glass_.pixels.assign(std::size_t{glass_.width} * glass_.height, 0xff000000U);
}

const ig::VideoFrame& RetroDisplay::show(const ig::VideoFrame& picture, std::uint32_t field) {
    scan(picture, field);
    glow();
    enlarge();
    return glass_;
}

const ig::VideoFrame& RetroDisplay::photograph(const ig::VideoFrame& picture) {
    exposed_.assign(held_.size(), 0);
    for (std::uint32_t field = 0; field < fields_; ++field) {
        scan(picture, field);
        glow();
        std::ranges::transform(exposed_, emitted_, exposed_.begin(), std::plus());
    }
    std::ranges::transform(exposed_, emitted_.begin(),
                           [this](std::uint32_t sum) { return (sum + fields_ / 2) / fields_; });
    enlarge();
    return glass_;
}

void RetroDisplay::scan(const ig::VideoFrame& picture, std::uint32_t field) {
    assert(picture.width == raster_.width && picture.height == raster_.height);
    const bool horizontal = raster_.scan == ig::Scan::horizontal;
    for (std::uint32_t row = 0; row < raster_.height; ++row) {
        for (std::uint32_t column = 0; column < raster_.width; ++column) {
            if ((horizontal ? row : column) % fields_ != field) continue;
            const std::size_t at = std::size_t{row} * raster_.width + column;
            for (std::uint32_t component = 0; component < 3; ++component)
                held_[3 * at + component] += fields_ * whole * (picture.pixels[at] >> 8U * component & 0xffU);
        }
    }
}

void RetroDisplay::glow() {
    for (std::size_t k = 0; k < held_.size(); ++k) {
        // The last level's worth leaves at once: a dark screen becomes dark.
        const std::uint32_t leaves = held_[k] < whole ? held_[k] : held_[k] * released / whole;
        emitted_[k] = std::min(brightest, leaves);
        held_[k] -= emitted_[k];
    }
}

/// Along a line pixels run into each other: every second place is the mean of its neighbours.
void RetroDisplay::smear(std::uint32_t line, LineLight& out) const {
    const bool horizontal = raster_.scan == ig::Scan::horizontal;
    const std::size_t start = 3 * std::size_t{line} * (horizontal ? raster_.elements() : 1);
    const std::size_t step = 3 * std::size_t{horizontal ? 1 : raster_.lines()};
    const std::size_t elements = raster_.elements();
    for (std::size_t element = 0; element < elements; ++element) {
        const std::uint32_t* here = emitted_.data() + start + element * step;
        const std::uint32_t* next = element + 1 < elements ? here + step : here;
        for (std::size_t c = 0; c < 3; ++c) {
            const std::size_t at = 6 * element + c;
            const Halves first = halves(here[c]);
            const Halves second = halves((here[c] + next[c]) / 2);
            out.middle[at] = first.middle;
            out.border[at] = first.border;
            out.middle[at + 3] = second.middle;
            out.border[at + 3] = second.border;
        }
    }
}

/// Across the lines their middles alternate with borders, which neighbours share.
void RetroDisplay::enlarge() {
    LineLight* here = &line_light_[0];
    LineLight* next = &line_light_[1];
    smear(0, *here);
    for (std::uint32_t line = 0; line < raster_.lines(); ++line) {
        if (line + 1 < raster_.lines()) smear(line + 1, *next);
        const LineLight& below = line + 1 < raster_.lines() ? *next : *here;
        for (std::uint32_t element = 0; element < 2 * raster_.elements(); ++element) {
            const std::size_t at = 3 * std::size_t{element};
            const auto border = [&](std::size_t c) {
                return (here->border[at + c] + below.border[at + c]) / 2;
            };
            glass_at(2 * line, element) =
                levels(here->middle[at], here->middle[at + 1], here->middle[at + 2]);
            glass_at(2 * line + 1, element) = levels(border(0), border(1), border(2));
        }
        std::swap(here, next);
    }
}

std::uint32_t& RetroDisplay::glass_at(std::uint32_t line, std::uint32_t element) {
    const bool horizontal = raster_.scan == ig::Scan::horizontal;
    return glass_.pixels[horizontal ? std::size_t{line} * glass_.width + element
                                    : std::size_t{element} * glass_.width + line];
}

} // namespace linkdig::tools
