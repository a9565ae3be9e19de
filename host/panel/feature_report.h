#pragma once
/// From lamps and texts to the bytes of a panel's feature report.

#include "host/panel/layout.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace linkdig::panel {

/// What a panel shows; parallel to its layout's lamps and displays.
struct PanelFace {
    std::vector<bool> lamps;
    std::vector<std::string> texts; ///< digits, spaces, '-' and '.', to the right of the display
};

/// Everything dark.
PanelFace dark_face(const PanelLayout& layout);

/// Does the text fit on the display? A dot takes no place of its own.
bool fits(const Display& display, std::string_view text);

/// A number as the display shows it, so many decimals as it has dots for; empty for a NaN. What does not fit is shown as dashes,
/// or as nothing where there is no dash.
std::string number_text(const Display& display, double value, std::uint32_t decimals);

/// The bytes that follow the report's number 0. A text that does not fit is shown as number_text() says.
std::vector<std::uint8_t> feature_report(const PanelLayout& layout, const PanelFace& face);

} // namespace linkdig::panel
