#include "host/panel/panel_desk.h"

#include "host/panel/signal_unit.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace linkdig::panel {

using What = PanelEvent::What;

std::string name_of(const PanelPlace& place) {
    return fmt::format("{} panel at {}", layout_of(place.kind).name, place.port);
}

PanelDesk::PanelDesk(std::vector<Mapping> mappings, host::SignalStore& signals,
                     const host::IndicationStore& indications, Tell tell)
    : mappings_(std::move(mappings)), signals_(signals), indications_(indications), tell_(std::move(tell)),
      overwritten_(signals.overwritten()) {
    events_.reserve(report_bits);
}

PanelDesk::Panel* PanelDesk::find(const PanelPlace& place) {
    const auto found = std::ranges::find(panels_, place, &Panel::place);
    return found == panels_.end() ? nullptr : &*found;
}

void PanelDesk::attached(const PanelPlace& place) {
    const bool again = find(place) != nullptr;
    if (!again)
        panels_.push_back({place, mapping_for(mappings_, place.kind, place.port), ReportDecoder(place.kind)});
    const bool mapped = find(place)->mapping != nullptr;
    tell_(fmt::format("{} is connected{}{}", name_of(place), again ? " again" : "",
                      mapped ? "" : "; no mapping names it"));
}

void PanelDesk::detached(const PanelPlace& place) {
    tell_(fmt::format("{} has gone; its switches count as they stood", name_of(place)));
}

void PanelDesk::report(const PanelPlace& place, std::span<const std::uint8_t> bytes, ReportSource source,
                       double now_s) {
    Panel* panel = find(place);
    if (panel == nullptr || panel->mapping == nullptr) return;
    const bool counts = panel->limit.take(now_s);
    if (!counts && !std::exchange(panel->told_flood, true))
        tell_(fmt::format("{} sends more than {} reports a second; beyond that only its switches count",
                          name_of(place), most_reports_per_s));
    events_.clear();
    if (!panel->decoder.decode(bytes, source, events_) && !std::exchange(panel->told_length, true))
        tell_(fmt::format("{} sent {} bytes; expected {}; such reports are passed over", name_of(place),
                          bytes.size(), report_bytes));
    for (PanelEvent& event : events_) {
        event.fresh = event.fresh && counts;
        apply(*panel, event);
    }
}

void PanelDesk::turn(double /*now_s*/) {
    const std::uint64_t overwritten = signals_.overwritten();
    if (std::exchange(overwritten_, overwritten) == overwritten) return;
    for (const Panel& panel : panels_) {
        events_.clear();
        panel.decoder.tell(events_);
        if (panel.mapping == nullptr) continue;
        for (const PanelEvent& event : events_)
            apply(panel, event);
    }
}

void PanelDesk::apply(const Panel& panel, const PanelEvent& event) {
    const Mapping& mapping = *panel.mapping;
    if (event.what == What::on || event.what == What::off)
        for (const SwitchBinding& each : mapping.switches)
            if (each.control == event.control)
                signals_.write(each.signal, event.what == What::on ? each.on : each.off);
    if (event.what == What::at)
        for (const SelectorBinding& each : mapping.selectors)
            if (each.control == event.control && each.values[event.position])
                signals_.write(each.signal, *each.values[event.position]);
    if (event.fresh) press(panel, event);
}

void PanelDesk::press(const Panel& panel, const PanelEvent& event) {
    for (const ButtonBinding& each : panel.mapping->buttons) {
        const bool pressed =
            each.at ? event.what == What::at && event.position == *each.at : event.what == What::on;
        if (each.control == event.control && pressed && holds(panel, each.when)) act(each.step, 1.0);
    }
    if (event.what != What::up && event.what != What::down) return;
    for (const EncoderBinding& each : panel.mapping->encoders)
        if (each.control == event.control && holds(panel, each.when))
            act(each.step, event.what == What::up ? 1.0 : -1.0);
}

void PanelDesk::act(const Step& step, double sign) {
    if (step.to)
        signals_.write(step.signal, *step.to);
    else if (step.by && step.wraps)
        signals_.add_round(step.signal, sign * *step.by);
    else if (step.by)
        signals_.add(step.signal, sign * *step.by);
    else if (host::definition(step.signal).kind == host::SignalKind::pulse)
        signals_.write(step.signal, 1.0);
    else
        signals_.change_over(step.signal);
}

bool PanelDesk::holds(const Panel& panel, const std::optional<Stand>& when) const {
    return !when || panel.decoder.position(when->control) == when->position;
}

double PanelDesk::value(const Shown& shown) const {
    if (const auto* signal = std::get_if<host::Signal>(&shown)) return signals_.value(*signal);
    return indications_.value(std::get<host::Indication>(shown));
}

namespace {

/// Of several bindings of a lamp or display the one whose selector stands right; without any, the one that asks for no selector.
template <typename Binding, typename Holds>
const Binding* choose(const std::vector<Binding>& bindings, std::uint8_t Binding::*which, std::size_t index,
                      const Holds& holds) {
    const Binding* always = nullptr;
    for (const Binding& each : bindings) {
        if (each.*which != index) continue;
        if (each.when && holds(each.when)) return &each;
        if (!each.when) always = &each;
    }
    return always;
}

} // namespace

bool PanelDesk::lit(const Panel& panel, std::size_t lamp) const {
    const auto* binding = choose(panel.mapping->lamps, &LampBinding::lamp, lamp,
                                 [&](const auto& when) { return holds(panel, when); });
    if (binding == nullptr) return false;
    const double now = value(binding->shows);
    return now >= binding->at_least && now < binding->below; // never for a NaN
}

std::string PanelDesk::text(const Panel& panel, std::size_t index) const {
    const auto* binding = choose(panel.mapping->displays, &DisplayBinding::display, index,
                                 [&](const auto& when) { return holds(panel, when); });
    if (binding == nullptr) return {};
    const Display& display = layout_of(panel.place.kind).displays[index];
    const double now = value(binding->shows);
    const bool sea_state = binding->shows == Shown(host::Indication::sea_state);
    if (sea_state && now == 1.5 && display.dash) return "1-2"; // as the report writes it
    return number_text(display, now / unit_of(binding->shows).in_si, binding->decimals);
}

std::vector<std::uint8_t> PanelDesk::wanted(const PanelPlace& place) {
    const Panel* panel = find(place);
    if (panel == nullptr || panel->mapping == nullptr) return {};
    const PanelLayout& layout = layout_of(place.kind);
    PanelFace face = dark_face(layout);
    for (std::size_t i = 0; i < face.lamps.size(); ++i)
        face.lamps[i] = lit(*panel, i);
    for (std::size_t i = 0; i < face.texts.size(); ++i)
        face.texts[i] = text(*panel, i);
    return feature_report(layout, face);
}

} // namespace linkdig::panel
