#include "host/panel/report_decoder.h"

#include <bit>

namespace linkdig::panel {

namespace {

using What = PanelEvent::What;

/// The control's own bits, its first one lowest.
std::uint32_t own(const Control& control, std::uint32_t bits) {
    return bits >> control.first_bit & ((1U << control.bits()) - 1U);
}

} // namespace

bool ReportDecoder::decode(std::span<const std::uint8_t> report, ReportSource source,
                           std::vector<PanelEvent>& events) {
    if (report.size() != report_bytes) return false;
    const std::uint32_t now = report[0] | static_cast<std::uint32_t>(report[1]) << 8U |
                              static_cast<std::uint32_t>(report[2]) << 16U;
    for (std::size_t i = 0; i < layout_->controls.size(); ++i)
        decode_control(static_cast<std::uint8_t>(i), bits_.value_or(0), now, source, events);
    bits_ = now;
    return true;
}

void ReportDecoder::decode_control(std::uint8_t index, std::uint32_t before, std::uint32_t now,
                                   ReportSource source, std::vector<PanelEvent>& events) {
    const Control& control = layout_->controls[index];
    const std::uint32_t old_bits = own(control, before);
    const std::uint32_t bits = own(control, now);
    const bool fresh = source == ReportSource::sent;
    switch (control.kind) {
    case ControlKind::toggle:
        if (!bits_ || bits != old_bits)
            events.push_back({index, bits != 0 ? What::on : What::off, 0, fresh && bits != 0});
        break;
    case ControlKind::selector: {
        if (!std::has_single_bit(bits)) break; // between two stops, or nonsense: it stands where it stood
        const auto position = static_cast<std::uint8_t>(std::countr_zero(bits));
        if (position == positions_[index]) break;
        events.push_back({index, What::at, position, fresh && positions_[index] != nowhere});
        positions_[index] = position;
        break;
    }
    case ControlKind::encoder:
        if (!fresh || !std::has_single_bit(bits) || (bits & old_bits) != 0) break;
        events.push_back({index, (bits == 1) != control.first_is_down ? What::up : What::down, 0, true});
        break;
    }
}

void ReportDecoder::tell(std::vector<PanelEvent>& events) const {
    for (std::size_t i = 0; i < layout_->controls.size(); ++i) {
        const Control& control = layout_->controls[i];
        const auto index = static_cast<std::uint8_t>(i);
        if (control.kind == ControlKind::toggle && bits_)
            events.push_back({index, own(control, *bits_) != 0 ? What::on : What::off, 0, false});
        if (control.kind == ControlKind::selector && positions_[i] != nowhere)
            events.push_back({index, What::at, positions_[i], false});
    }
}

std::optional<std::size_t> ReportDecoder::position(std::size_t control) const {
    if (positions_[control] == nowhere) return std::nullopt;
    return positions_[control];
}

} // namespace linkdig::panel
