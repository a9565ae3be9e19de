#include "host/panel/feature_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace linkdig::panel {

namespace {

constexpr std::uint8_t blank = 0x0f;

bool is_digit(char letter) { return letter >= '0' && letter <= '9'; }

std::size_t places(std::string_view text) {
    return text.size() - static_cast<std::size_t>(std::ranges::count(text, '.'));
}

std::string overflow(const Display& display) {
    return display.dash ? std::string(display_digits, '-') : std::string();
}

std::uint8_t code_of(const Display& display, char letter) {
    if (is_digit(letter)) return static_cast<std::uint8_t>(letter - '0');
    return letter == '-' ? display.dash.value_or(blank) : blank;
}

/// From the right, so that a short text stands there.
void put(const Display& display, std::string_view text, std::vector<std::uint8_t>& bytes) {
    std::size_t at = display.first_byte + display_digits;
    std::uint8_t dot = 0;
    for (auto letter = text.rbegin(); letter != text.rend(); ++letter) {
        if (*letter == '.') {
            dot = display.with_dot.value_or(0);
            continue;
        }
        bytes[--at] = static_cast<std::uint8_t>(code_of(display, *letter) + dot);
        dot = 0;
    }
}

} // namespace

PanelFace dark_face(const PanelLayout& layout) {
    return {std::vector<bool>(layout.lamps.size(), false), std::vector<std::string>(layout.displays.size())};
}

bool fits(const Display& display, std::string_view text) {
    bool after_digit = false;
    for (const char letter : text) {
        if (letter == '.' && (!display.with_dot || !after_digit)) return false;
        if (letter == '-' && !display.dash) return false;
        if (!is_digit(letter) && letter != '.' && letter != '-' && letter != ' ') return false;
        after_digit = is_digit(letter);
    }
    return places(text) <= display_digits;
}

std::string number_text(const Display& display, double value, std::uint32_t decimals) {
    if (std::isnan(value)) return {};
    if (std::abs(value) > 99999.5) return overflow(display);
    std::string text = fmt::format("{:.{}f}", value, display.with_dot ? decimals : 0);
    if (text.find_first_of("123456789") == std::string::npos && text.front() == '-') text.erase(0, 1); // -0
    return fits(display, text) ? text : overflow(display);
}

std::vector<std::uint8_t> feature_report(const PanelLayout& layout, const PanelFace& face) {
    std::vector<std::uint8_t> bytes(layout.dark.begin(), layout.dark.end());
    for (std::size_t i = 0; i < layout.lamps.size(); ++i)
        if (face.lamps[i]) bytes[layout.lamps[i].byte] |= layout.lamps[i].mask;
    for (std::size_t i = 0; i < layout.displays.size(); ++i) {
        const Display& display = layout.displays[i];
        put(display, fits(display, face.texts[i]) ? face.texts[i] : overflow(display), bytes);
    }
    return bytes;
}

} // namespace linkdig::panel
