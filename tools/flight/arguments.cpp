#include "tools/flight/arguments.h"

#include <fmt/format.h>

#include <charconv>
#include <optional>
#include <stdexcept>
#include <string_view>

namespace linkdig::tools {
namespace {

template <class Number>
std::optional<Number> whole_number(std::string_view text) {
    Number value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return value;
}

constexpr std::uint32_t smallest_side = 16;

} // namespace

PictureSize parse_size(const std::string& text) {
    const std::size_t cross = text.find('x');
    if (cross != std::string::npos) {
        const auto width = whole_number<std::uint32_t>(std::string_view(text).substr(0, cross));
        const auto height = whole_number<std::uint32_t>(std::string_view(text).substr(cross + 1));
        const auto fits = [](std::uint32_t side) {
            return side >= smallest_side && side <= ig::max_raster_side;
        };
        if (width && height && fits(*width) && fits(*height)) return {*width, *height};
    }
    throw std::invalid_argument(
        fmt::format("'{}' is no picture size; expected WIDTHxHEIGHT, {} to {} pixels each", text,
                    smallest_side, ig::max_raster_side));
}

FrameRange parse_frames(const std::string& text) {
    const std::size_t colon = text.find(':');
    const auto first = whole_number<std::uint64_t>(std::string_view(text).substr(0, colon));
    const auto last = colon == std::string::npos
                          ? first
                          : whole_number<std::uint64_t>(std::string_view(text).substr(colon + 1));
    if (!first || !last || *first > *last)
        throw std::invalid_argument(fmt::format(
            "'{}' is no range of frames; expected FIRST:LAST, FIRST not above LAST, or one frame", text));
    return {*first, *last};
}

ig::Configuration configuration_of(const std::string& profile, const std::optional<std::string>& size,
                                   std::optional<double> frames_per_second, std::uint32_t threads,
                                   bool no_smoothing) {
    ig::Configuration configuration = profile == "ames" ? ig::ames_profile() : ig::modern_profile();
    configuration.threads = threads;
    if (no_smoothing) configuration.edge_smoothing = false;
    if (frames_per_second) configuration.update_rate_hz = *frames_per_second;
    if (size) {
        const PictureSize asked = parse_size(*size);
        configuration.raster.width = asked.width;
        configuration.raster.height = asked.height;
    }
    return configuration;
}

} // namespace linkdig::tools
