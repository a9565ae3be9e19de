#include "host/panel/layout.h"

#include <algorithm>

namespace linkdig::panel {

namespace {

using enum ControlKind;

constexpr std::array magneto{"off", "right", "left", "both", "start"};
constexpr std::array gear{"up", "down"};
constexpr std::array figures{"alt", "vs", "ias", "hdg", "crs"};
constexpr std::array radios{"com1", "com2", "nav1", "nav2", "adf", "dme", "xpdr"};

constexpr std::array switch_controls{
    Control{toggle, "battery", 0},       Control{toggle, "alternator", 1},
    Control{toggle, "avionics", 2},      Control{toggle, "fuel_pump", 3},
    Control{toggle, "de_ice", 4},        Control{toggle, "pitot_heat", 5},
    Control{toggle, "cowl", 6},          Control{toggle, "panel_light", 7},
    Control{toggle, "beacon", 8},        Control{toggle, "nav", 9},
    Control{toggle, "strobe", 10},       Control{toggle, "taxi", 11},
    Control{toggle, "landing", 12},      Control{selector, "magneto", 13, magneto},
    Control{selector, "gear", 18, gear},
};
constexpr std::array multi_controls{
    Control{selector, "selector", 0, figures},
    Control{encoder, "encoder", 5},
    Control{toggle, "ap", 7},
    Control{toggle, "hdg", 8},
    Control{toggle, "nav", 9},
    Control{toggle, "ias", 10},
    Control{toggle, "alt", 11},
    Control{toggle, "vs", 12},
    Control{toggle, "apr", 13},
    Control{toggle, "rev", 14},
    Control{toggle, "auto_throttle", 15},
    Control{toggle, "flaps_up", 16},
    Control{toggle, "flaps_down", 17},
    Control{encoder, "trim", 18, {}, true},
};
constexpr std::array radio_controls{
    Control{selector, "upper", 0, radios}, Control{selector, "lower", 7, radios},
    Control{toggle, "upper_act", 14},      Control{toggle, "lower_act", 15},
    Control{encoder, "upper_inner", 16},   Control{encoder, "upper_outer", 18},
    Control{encoder, "lower_inner", 20},   Control{encoder, "lower_outer", 22},
};

// Green and red of a gear lamp together are yellow.
constexpr std::array switch_lamps{
    Lamp{"nose_green", 0, 0x01}, Lamp{"left_green", 0, 0x02}, Lamp{"right_green", 0, 0x04},
    Lamp{"nose_red", 0, 0x08},   Lamp{"left_red", 0, 0x10},   Lamp{"right_red", 0, 0x20},
};
constexpr std::array multi_lamps{
    Lamp{"ap", 10, 0x01},  Lamp{"hdg", 10, 0x02}, Lamp{"nav", 10, 0x04}, Lamp{"ias", 10, 0x08},
    Lamp{"alt", 10, 0x10}, Lamp{"vs", 10, 0x20},  Lamp{"apr", 10, 0x40}, Lamp{"rev", 10, 0x80},
};

constexpr std::array multi_displays{Display{"top", 0}, Display{"bottom", 5, 0xde}};
constexpr std::array radio_displays{
    Display{"upper_left", 0, 0xe0, 0xd0}, Display{"upper_right", 5, 0xe0, 0xd0},
    Display{"lower_left", 10, 0xe0, 0xd0}, Display{"lower_right", 15, 0xe0, 0xd0}};

constexpr std::array<std::uint8_t, 1> dark_switches{0};
constexpr std::array<std::uint8_t, 12> dark_multi{0x0f, 0x0f, 0x0f, 0x0f, 0x0f, 0x0f,
                                                  0x0f, 0x0f, 0x0f, 0x0f, 0x00, 0xff};
constexpr std::array<std::uint8_t, 22> dark_radio{0x0f, 0x0f, 0x0f, 0x0f, 0x0f, 0x0f, 0x0f, 0x0f,
                                                  0x0f, 0x0f, 0x0f, 0x0f, 0x0f, 0x0f, 0x0f, 0x0f,
                                                  0x0f, 0x0f, 0x0f, 0x0f, 0x00, 0x00};

constexpr std::array<PanelLayout, panel_kinds> layouts{{
    {PanelKind::switches, "switch", 0x0d67, switch_controls, switch_lamps, {}, dark_switches},
    {PanelKind::multi, "multi", 0x0d06, multi_controls, multi_lamps, multi_displays, dark_multi},
    {PanelKind::radio, "radio", 0x0d05, radio_controls, {}, radio_displays, dark_radio},
}};

template <typename Named>
std::optional<std::size_t> index_of(std::span<const Named> all, std::string_view name) {
    const auto found = std::ranges::find_if(all, [&](const Named& each) { return name == each.name; });
    if (found == all.end()) return std::nullopt;
    return static_cast<std::size_t>(found - all.begin());
}

} // namespace

const PanelLayout& layout_of(PanelKind kind) { return layouts[static_cast<std::size_t>(kind)]; }

std::optional<PanelKind> kind_of_product(std::uint16_t product_id) {
    for (const PanelLayout& each : layouts)
        if (each.product_id == product_id) return each.kind;
    return std::nullopt;
}

std::optional<PanelKind> find_panel(std::string_view name) {
    for (const PanelLayout& each : layouts)
        if (name == each.name) return each.kind;
    return std::nullopt;
}

std::optional<std::size_t> find_control(const PanelLayout& layout, std::string_view name) {
    return index_of(layout.controls, name);
}

std::optional<std::size_t> find_lamp(const PanelLayout& layout, std::string_view name) {
    return index_of(layout.lamps, name);
}

std::optional<std::size_t> find_display(const PanelLayout& layout, std::string_view name) {
    return index_of(layout.displays, name);
}

std::optional<std::size_t> find_position(const Control& control, std::string_view name) {
    for (std::size_t i = 0; i < control.positions.size(); ++i)
        if (name == control.positions[i]) return i;
    return std::nullopt;
}

} // namespace linkdig::panel
