#pragma once
/// The data sheet of the Logitech (Saitek) Pro Flight panels: which bit of a report is which control, and which byte of the
/// feature report is which lamp or digit. Bits and codes: agreed on by several public drivers of these panels; none of Logitech's
/// own is public (docs/panel.md).

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace linkdig::panel {

inline constexpr std::uint16_t vendor_id = 0x06a3;
/// Input: all bits each time one changes, without report id. Anything of another length is no report.
inline constexpr std::size_t report_bytes = 3;
inline constexpr std::size_t report_bits = 8 * report_bytes;

enum class PanelKind : std::uint8_t { switches, multi, radio };
inline constexpr std::size_t panel_kinds = 3;

enum class ControlKind : std::uint8_t {
    toggle,   ///< one bit: a switch that stays, or a button that is held
    selector, ///< a bit per position; at rest exactly one is set, and between two stops none
    encoder,  ///< two bits, one for each way; each notch sets one and clears it again
};

/// A control has bits that follow one another.
struct Control {
    ControlKind kind;
    const char* name;
    std::uint8_t first_bit; ///< of the report, from the lowest of byte 0
    std::span<const char* const> positions{};
    bool first_is_down = false; ///< an encoder whose first bit turns down

    std::size_t bits() const {
        return kind == ControlKind::toggle ? 1 : kind == ControlKind::encoder ? 2 : positions.size();
    }
};

struct Lamp {
    const char* name;
    std::uint8_t byte; ///< of the feature report
    std::uint8_t mask;
};

inline constexpr std::size_t display_digits = 5;

/// Five digits, the leftmost first.
struct Display {
    const char* name;
    std::uint8_t first_byte;
    std::optional<std::uint8_t> dash{};     ///< code of a dash; none: it has no dash
    std::optional<std::uint8_t> with_dot{}; ///< added to a digit: the dot behind it; none: it has no dots
};

struct PanelLayout {
    PanelKind kind;
    const char* name; ///< as in mapping files: "switch", "multi", "radio"
    std::uint16_t product_id;
    std::span<const Control> controls;
    std::span<const Lamp> lamps;
    std::span<const Display> displays;
    std::span<const std::uint8_t> dark; ///< feature report (number 0) with every lamp and digit dark
};

const PanelLayout& layout_of(PanelKind kind);
std::optional<PanelKind> kind_of_product(std::uint16_t product_id);
std::optional<PanelKind> find_panel(std::string_view name);

/// Index of the named control, lamp or display, if the panel has one.
std::optional<std::size_t> find_control(const PanelLayout& layout, std::string_view name);
std::optional<std::size_t> find_lamp(const PanelLayout& layout, std::string_view name);
std::optional<std::size_t> find_display(const PanelLayout& layout, std::string_view name);
std::optional<std::size_t> find_position(const Control& control, std::string_view name);

} // namespace linkdig::panel
