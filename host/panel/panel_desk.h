#pragma once
/// The panels of a flight: what is done at their controls goes into the signals, and what the flight tells comes back to their lamps
/// and displays, as their mappings say. The flight's thread and the link's meet in the two stores alone, where nobody waits.

#include "host/panel/feature_report.h"
#include "host/panel/mapping.h"
#include "host/panel/panel_user.h"
#include "host/panel/report_limit.h"
#include "host/signals/indications.h"
#include "host/signals/signal_store.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace linkdig::panel {

/// Where words about panels go, a sentence at a time, from the link's thread.
using Tell = std::function<void(const std::string&)>;

class PanelDesk final : public PanelUser {
public:
    /// The stores must outlive the desk.
    PanelDesk(std::vector<Mapping> mappings, host::SignalStore& signals,
              const host::IndicationStore& indications, Tell tell);

    void attached(const PanelPlace& place) override;
    void detached(const PanelPlace& place) override;
    void report(const PanelPlace& place, std::span<const std::uint8_t> bytes, ReportSource source,
                double now_s) override;
    /// When somebody has overwritten all signals, every switch and selector writes its own anew.
    void turn(double now_s) override;
    std::vector<std::uint8_t> wanted(const PanelPlace& place) override;

private:
    /// A panel that was plugged in once; one that has gone keeps its switches in mind.
    struct Panel {
        PanelPlace place;
        const Mapping* mapping = nullptr; ///< none: it does nothing
        ReportDecoder decoder;
        ReportLimit limit{};
        bool told_length = false;
        bool told_flood = false;
    };

    Panel* find(const PanelPlace& place);
    void apply(const Panel& panel, const PanelEvent& event);
    void press(const Panel& panel, const PanelEvent& event);
    void act(const Step& step, double sign);
    bool holds(const Panel& panel, const std::optional<Stand>& when) const;
    double value(const Shown& shown) const;
    std::string text(const Panel& panel, std::size_t display) const;
    bool lit(const Panel& panel, std::size_t lamp) const;

    std::vector<Mapping> mappings_;
    host::SignalStore& signals_;
    const host::IndicationStore& indications_;
    Tell tell_;
    std::vector<Panel> panels_;
    std::vector<PanelEvent> events_; ///< its memory
    std::uint64_t overwritten_;
};

} // namespace linkdig::panel
