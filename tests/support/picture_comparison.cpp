#include "tests/support/picture_comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <vector>

namespace linkdig::support {

namespace {

constexpr std::uint32_t map_columns = 64;
constexpr std::uint32_t map_rows = 32;

std::uint32_t level_difference(std::uint32_t a, std::uint32_t b) {
    std::uint32_t worst = 0;
    for (std::uint32_t shift = 0; shift < 32; shift += 8) {
        const auto x = static_cast<std::int32_t>(a >> shift & 0xffU);
        const auto y = static_cast<std::int32_t>(b >> shift & 0xffU);
        worst = std::max(worst, static_cast<std::uint32_t>(std::abs(x - y)));
    }
    return worst;
}

/// How badly pixel `at` differs: 0 equal, 1 by a level, 2 by more, 3 another face.
int severity(const ig::VideoFrame& a, const ig::VideoFrame& b, std::size_t at) {
    if (!a.rank.empty() && !b.rank.empty() && a.rank[at] != b.rank[at]) return 3;
    const std::uint32_t levels = level_difference(a.pixels[at], b.pixels[at]);
    return levels > 1 ? 2 : static_cast<int>(levels);
}

std::string map_of(const std::vector<int>& severities, std::uint32_t width, std::uint32_t height) {
    const std::uint32_t columns = std::min(width, map_columns);
    const std::uint32_t rows = std::min(height, map_rows);
    std::string cells(std::size_t{columns} * rows, ' ');
    for (std::size_t at = 0; at < severities.size(); ++at) {
        const auto column = static_cast<std::uint32_t>(at % width) * columns / width;
        const auto row = static_cast<std::uint32_t>(at / width) * rows / height;
        char& cell = cells[std::size_t{row} * columns + column];
        constexpr char signs[] = {' ', '.', '+', '#'};
        const auto* previous = std::find(signs, signs + 4, cell);
        cell = signs[std::max<std::ptrdiff_t>(severities[at], previous - signs)];
    }
    std::string map;
    for (std::uint32_t row = 0; row < rows; ++row)
        map += "  |" + cells.substr(std::size_t{row} * columns, columns) + "|\n";
    return map;
}

std::int32_t value_at(const std::vector<std::int32_t>& plane, std::size_t at) {
    return plane.empty() ? -1 : plane[at];
}

std::string explain(const PictureDifference& d, const ig::VideoFrame& expected, const ig::VideoFrame& actual,
                    const std::vector<int>& severities) {
    const std::size_t at = std::size_t{d.row} * expected.width + d.column;
    return fmt::format(
               "{} of {} pixels differ, {} show another face; at most {} levels, intensity {} of 2^22\n"
               "  worst at column {} row {}: expected {:08x} rank {} intensity {}, got {:08x} rank {} "
               "intensity {}\n",
               d.pixels, expected.pixels.size(), d.ranks, d.worst_level, d.worst_intensity, d.column, d.row,
               expected.pixels[at], value_at(expected.rank, at), value_at(expected.intensity, at),
               actual.pixels[at], value_at(actual.rank, at), value_at(actual.intensity, at)) +
           map_of(severities, expected.width, expected.height);
}

} // namespace

PictureDifference compare(const ig::VideoFrame& expected, const ig::VideoFrame& actual) {
    PictureDifference d;
    if (expected.width != actual.width || expected.height != actual.height ||
        expected.pixels.size() != actual.pixels.size()) {
        d.worst_level = 255;
        d.pixels = expected.pixels.size();
        d.explanation = fmt::format("expected {} x {} pixels, got {} x {}\n", expected.width, expected.height,
                                    actual.width, actual.height);
        return d;
    }
    std::vector<int> severities(expected.pixels.size());
    std::pair<int, std::uint32_t> worst{0, 0};
    std::size_t worst_at = 0;
    for (std::size_t at = 0; at < severities.size(); ++at) {
        severities[at] = severity(expected, actual, at);
        const std::uint32_t levels = level_difference(expected.pixels[at], actual.pixels[at]);
        d.worst_level = std::max(d.worst_level, levels);
        d.pixels += levels > 0 || severities[at] == 3 ? 1 : 0;
        d.ranks += severities[at] == 3 ? 1 : 0;
        if (severities[at] != 3 && !expected.intensity.empty() && !actual.intensity.empty())
            d.worst_intensity =
                std::max(d.worst_intensity, std::abs(expected.intensity[at] - actual.intensity[at]));
        if (std::pair(severities[at], levels) <= worst) continue;
        worst = {severities[at], levels};
        worst_at = at;
    }
    d.column = static_cast<std::uint32_t>(worst_at % expected.width);
    d.row = static_cast<std::uint32_t>(worst_at / expected.width);
    if (d.pixels > 0) d.explanation = explain(d, expected, actual, severities);
    return d;
}

} // namespace linkdig::support
