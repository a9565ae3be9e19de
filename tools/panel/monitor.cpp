#include "tools/panel/monitor.h"

#include <fmt/format.h>

#include <algorithm>

namespace linkdig::tools {

namespace {

std::string words_of(const panel::Control& control, const panel::PanelEvent& event) {
    using What = panel::PanelEvent::What;
    switch (event.what) {
    case What::off:
        return "off";
    case What::on:
        return "on";
    case What::at:
        return control.positions[event.position];
    case What::up:
        return "up";
    case What::down:
        return "down";
    }
    return {};
}

} // namespace

panel::ReportDecoder* PanelMonitor::find(const panel::PanelPlace& place) {
    const auto found = std::ranges::find(panels_, place, &Panel::place);
    return found == panels_.end() ? nullptr : &found->decoder;
}

void PanelMonitor::attached(const panel::PanelPlace& place) {
    std::erase_if(panels_, [&](const Panel& each) { return each.place == place; });
    panels_.push_back({place, panel::ReportDecoder(place.kind)});
    tell_({place, "", "connected"});
}

void PanelMonitor::detached(const panel::PanelPlace& place) { tell_({place, "", "gone"}); }

void PanelMonitor::report(const panel::PanelPlace& place, std::span<const std::uint8_t> bytes,
                          panel::ReportSource source, double /*now_s*/) {
    panel::ReportDecoder* decoder = find(place);
    if (decoder == nullptr) return;
    events_.clear();
    if (!decoder->decode(bytes, source, events_)) {
        tell_({place, "", fmt::format("no report: {} bytes", bytes.size())});
        return;
    }
    for (const panel::PanelEvent& event : events_) {
        const panel::Control& control = panel::layout_of(place.kind).controls[event.control];
        tell_({place, control.name, words_of(control, event), event.fresh});
    }
}

} // namespace linkdig::tools
