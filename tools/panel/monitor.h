#pragma once
/// What happens at the panels, as lines of text.

#include "host/panel/panel_user.h"
#include "host/panel/report_decoder.h"

#include <functional>
#include <string>
#include <vector>

namespace linkdig::tools {

/// Something that happened, in words.
struct PanelNews {
    panel::PanelPlace place;
    std::string control; ///< empty: of the panel as a whole
    std::string what;    ///< "on", "off", a position, "up", "down", "connected", "gone", "no report"
    bool fresh = true;   ///< somebody did it; else it is only told how it stands
};

/// Decodes and tells, and lights nothing.
class PanelMonitor final : public panel::PanelUser {
public:
    /// `tell` is called on the link's thread.
    explicit PanelMonitor(std::function<void(const PanelNews&)> tell) : tell_(std::move(tell)) {}

    void attached(const panel::PanelPlace& place) override;
    void detached(const panel::PanelPlace& place) override;
    void report(const panel::PanelPlace& place, std::span<const std::uint8_t> bytes,
                panel::ReportSource source, double now_s) override;
    void turn(double /*now_s*/) override {}
    std::vector<std::uint8_t> wanted(const panel::PanelPlace& /*place*/) override { return {}; }

private:
    struct Panel {
        panel::PanelPlace place;
        panel::ReportDecoder decoder;
    };
    panel::ReportDecoder* find(const panel::PanelPlace& place);

    std::function<void(const PanelNews&)> tell_;
    std::vector<Panel> panels_;
    std::vector<panel::PanelEvent> events_;
};

} // namespace linkdig::tools
