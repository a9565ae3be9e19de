#pragma once
/// Every lamp and every digit of the panels, one after the other.

#include "host/panel/feature_report.h"
#include "host/panel/panel_user.h"

#include <atomic>
#include <string>
#include <vector>

namespace linkdig::tools {

/// The steps of a panel's test: each lamp alone, then 0 to 9 on all displays, dots and dashes where there are any, everything, nothing.
std::vector<panel::PanelFace> lamp_test_faces(const panel::PanelLayout& layout);

/// Shows the steps on each panel from the moment that it is connected.
class LampTest final : public panel::PanelUser {
public:
    explicit LampTest(double step_s) : step_s_(step_s) {}

    void attached(const panel::PanelPlace& place) override;
    void detached(const panel::PanelPlace& place) override;
    void report(const panel::PanelPlace& /*place*/, std::span<const std::uint8_t> /*bytes*/,
                panel::ReportSource /*source*/, double /*now_s*/) override {}
    void turn(double now_s) override;
    std::vector<std::uint8_t> wanted(const panel::PanelPlace& place) override;

    /// Panels whose test is over, and those that are still being tested; read by any thread.
    std::size_t done() const { return done_; }
    std::size_t running() const { return running_; }

private:
    struct Panel {
        panel::PanelPlace place;
        std::vector<panel::PanelFace> faces;
        double begin_s = 0.0;
        bool over = false;
    };

    double step_s_;
    double now_s_ = 0.0;
    std::vector<Panel> panels_;
    std::atomic<std::size_t> done_{0};
    std::atomic<std::size_t> running_{0};
};

} // namespace linkdig::tools
