#include "tools/compare/region.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <stdexcept>

namespace linkdig::compare {
namespace {

/// "1,2,3"; empty if it is anything else.
template <class Number>
std::vector<Number> numbers_of(const std::string& text) {
    std::vector<Number> numbers;
    const char* const end = text.data() + text.size();
    for (const char* at = text.data();; ++at) {
        Number number{};
        const auto [stop, error] = std::from_chars(at, end, number);
        if (error != std::errc{} || (stop != end && *stop != ',')) return {};
        numbers.push_back(number);
        if (stop == end) return numbers;
        at = stop;
    }
}

void fill(std::vector<std::uint8_t>& counted, const Rectangle& r, std::uint32_t width, std::uint32_t height,
          std::uint8_t value) {
    const std::uint64_t right = std::min<std::uint64_t>(std::uint64_t{r.x} + r.width, width);
    const std::uint64_t bottom = std::min<std::uint64_t>(std::uint64_t{r.y} + r.height, height);
    for (std::uint64_t y = r.y; y < bottom; ++y)
        for (std::uint64_t x = r.x; x < right; ++x)
            counted[y * width + x] = value;
}

void lay_mask(std::vector<std::uint8_t>& counted, const Picture& mask) {
    std::vector<double> levels(std::size_t{mask.width} * mask.channels);
    for (std::uint32_t row = 0; row < mask.height; ++row) {
        row_levels(mask, row, levels.data());
        for (std::uint32_t x = 0; x < mask.width; ++x) {
            const auto* pixel = &levels[std::size_t{x} * mask.channels];
            const std::uint32_t colours =
                mask.channels == 2 || mask.channels == 4 ? mask.channels - 1 : mask.channels;
            if (std::all_of(pixel, pixel + colours, [](double level) { return level == 0.0; }))
                counted[std::size_t{row} * mask.width + x] = 0;
        }
    }
}

} // namespace

Rectangle parse_rectangle(const std::string& text) {
    const auto n = numbers_of<std::uint32_t>(text);
    if (n.size() != 4 || n[2] == 0 || n[3] == 0)
        throw std::invalid_argument(
            fmt::format("'{}' is no rectangle; expected X,Y,WIDTH,HEIGHT in pixels", text));
    return {n[0], n[1], n[2], n[3]};
}

std::array<double, 3> parse_colour(const std::string& text) {
    const auto n = numbers_of<double>(text);
    if (n.size() != 3 || !std::ranges::all_of(n, [](double level) { return level >= 0.0 && level <= 255.0; }))
        throw std::invalid_argument(fmt::format("'{}' is no colour; expected R,G,B, 0 to 255 each", text));
    return {n[0], n[1], n[2]};
}

std::vector<std::uint8_t> counted_pixels(const Regions& regions, std::uint32_t width, std::uint32_t height) {
    if (regions.everything()) return {};
    std::vector<std::uint8_t> counted(std::size_t{width} * height, regions.include.empty() ? 1 : 0);
    for (const Rectangle& r : regions.include)
        fill(counted, r, width, height, 1);
    for (const Rectangle& r : regions.ignore)
        fill(counted, r, width, height, 0);
    if (regions.mask) lay_mask(counted, *regions.mask);
    return counted;
}

std::string mask_mistake(const Regions& regions, std::uint32_t width, std::uint32_t height) {
    if (!regions.mask || (regions.mask->width == width && regions.mask->height == height)) return "";
    return fmt::format("the mask has {} x {} pixels; expected the frame's {} x {}", regions.mask->width,
                       regions.mask->height, width, height);
}

} // namespace linkdig::compare
