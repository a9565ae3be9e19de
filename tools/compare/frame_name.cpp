#include "tools/compare/frame_name.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <string_view>

namespace linkdig::compare {
namespace {

constexpr std::array planes{"list", "object", "face", "rank", "intensity"};

bool is_digit(char c) { return c >= '0' && c <= '9'; }

std::string without_trailing_marks(std::string text) {
    while (!text.empty() && std::string_view("_-. ").find(text.back()) != std::string_view::npos)
        text.pop_back();
    return text;
}

/// Is `word` the end of `series`, alone or after a mark?
bool ends_in_word(const std::string& series, std::string_view word) {
    if (!series.ends_with(word)) return false;
    const std::size_t before = series.size() - word.size();
    return before == 0 || std::isalnum(static_cast<unsigned char>(series[before - 1])) == 0;
}

void find_plane(FrameName& name) {
    name.prefix = name.series;
    if (ends_in_word(name.series, "colour")) name.prefix.resize(name.series.size() - 6);
    for (const char* plane : planes) {
        if (!ends_in_word(name.series, plane)) continue;
        name.plane = plane;
        name.prefix.resize(name.series.size() - name.plane.size());
    }
}

} // namespace

FrameName frame_name(const std::string& file) {
    const std::string stem = file.substr(0, file.rfind('.'));
    FrameName name;
    const auto last = std::find_if(stem.rbegin(), stem.rend(), is_digit).base();
    const auto first = std::find_if_not(std::make_reverse_iterator(last), stem.rend(), is_digit).base();
    std::uint64_t number = 0;
    const std::string digits(first, last);
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    name.series = stem;
    if (!digits.empty() && error == std::errc{}) {
        name.number = number;
        // What stands behind the number belongs to the series: left and right eye of 0001_l, 0001_r.
        name.series =
            without_trailing_marks(std::string(stem.begin(), first)) + std::string(last, stem.end());
    }
    find_plane(name);
    return name;
}

bool is_picture_file(const std::string& file) {
    const std::size_t dot = file.rfind('.');
    if (dot == std::string::npos) return false;
    std::string ending = file.substr(dot);
    std::ranges::transform(ending, ending.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    constexpr std::array endings{".png", ".exr", ".tif", ".tiff"};
    return std::ranges::find(endings, ending) != endings.end();
}

} // namespace linkdig::compare
