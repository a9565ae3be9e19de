#pragma once
/// From a panel's report to what has happened at its controls.

#include "host/panel/layout.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace linkdig::panel {

/// Something at a control.
struct PanelEvent {
    enum class What : std::uint8_t {
        off,
        on,
        at, ///< the selector stands at `position`
        up, ///< the encoder was turned one notch clockwise (a trim wheel up)
        down,
    };
    std::uint8_t control = 0; ///< index into PanelLayout::controls
    What what = What::off;
    std::uint8_t position = 0;
    bool fresh = false; ///< somebody has done it just now; else it is only told how the control stands
    bool operator==(const PanelEvent&) const = default;
};

enum class ReportSource : std::uint8_t {
    sent,  ///< by the panel, because something has changed
    asked, ///< the answer to a question: it says how the switches stand, not that anybody touched one
};

class ReportDecoder {
public:
    explicit ReportDecoder(PanelKind kind) : layout_(&layout_of(kind)) {}

    /// Appends what has changed since the report before; the first tells how every switch and selector stands. False, and nothing
    /// happens, if it has not the length of a report. What cannot be is passed over: a selector with two positions, an encoder
    /// turned both ways, bits that belong to nothing. Nothing is allocated once `events` has room.
    bool decode(std::span<const std::uint8_t> report, ReportSource source, std::vector<PanelEvent>& events);

    /// Appends how every switch and selector stands, as far as it is known.
    void tell(std::vector<PanelEvent>& events) const;
    /// Where a selector stands, if that is known.
    std::optional<std::size_t> position(std::size_t control) const;

private:
    void decode_control(std::uint8_t index, std::uint32_t before, std::uint32_t now, ReportSource source,
                        std::vector<PanelEvent>& events);

    static constexpr std::uint8_t nowhere = 0xff;
    static constexpr std::size_t most_controls = 16;
    const PanelLayout* layout_;
    std::optional<std::uint32_t> bits_; ///< of the report before
    std::array<std::uint8_t, most_controls> positions_ = filled_with_nowhere();

    static constexpr std::array<std::uint8_t, most_controls> filled_with_nowhere() {
        std::array<std::uint8_t, most_controls> all{};
        all.fill(nowhere);
        return all;
    }
};

} // namespace linkdig::panel
