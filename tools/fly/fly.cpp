#include "tools/fly/fly.h"

#include "host/loop/frame_clock.h"
#include "host/loop/simulation_counter.h"
#include "tools/fly/controls.h"
#include "tools/fly/status.h"
#include "tools/fly/window.h"

#include <array>
#include <optional>
#include <utility>

namespace linkdig::tools {
namespace {

/// What the picture on the screen was drawn from.
struct Shown {
    std::uint64_t frame = 0;
    host::SignalValues signals;
    bool operator==(const Shown&) const = default;
};

class Cockpit {
public:
    Cockpit(Flight& flight, Window& window, RetroDisplay* display)
        : flight_(flight), window_(window), display_(display) {
        text_[0] = {.corner = TextBlock::Corner::top_left, .lines = help_lines()};
        text_[1] = {.corner = TextBlock::Corner::bottom_left, .lines = {}};
    }

    /// One update; false when somebody has quit.
    bool update(std::uint64_t overruns) {
        for (const Action action : window_.actions())
            apply(action, flight_.loop(), counter_.frame(), signals_, screen_);
        const std::uint64_t frame = counter_.next(signals_.snapshot());
        const Shown wanted{frame, standing(signals_)};
        if (shown_ != wanted) draw(wanted, overruns);
        show(0);
        return !screen_.quit;
    }

    /// A field of the picture that was drawn last.
    void show(std::uint32_t field) {
        const ig::VideoFrame& picture = flight_.machine().picture(0);
        const std::size_t first = screen_.help ? 0 : 1;
        window_.show(display_ == nullptr ? picture : display_->show(picture, field),
                     std::span(text_).subspan(first));
    }

private:
    void draw(const Shown& wanted, std::uint64_t overruns) {
        FrameReport report = flight_.draw(wanted.frame, wanted.signals);
        report.overruns = overruns;
        text_[1].lines = status_lines(flight_.database(), flight_.packet(), report, wanted.signals);
        shown_ = wanted;
    }

    Flight& flight_;
    Window& window_;
    RetroDisplay* display_; ///< none: the picture as it is
    host::SignalStore signals_;
    host::SimulationCounter counter_;
    Screen screen_;
    std::array<TextBlock, 2> text_; ///< help, status
    std::optional<Shown> shown_;
};

} // namespace

FlyResult fly(Flight& flight, Window& window, std::uint64_t updates, RetroDisplay* display) {
    Cockpit cockpit(flight, window, display);
    const std::uint32_t fields = display == nullptr ? 1 : display->fields();
    const auto time = host::steady_time();
    host::FrameClock clock(flight.loop().update_rate_hz() * fields, *time);
    FlyResult result;
    bool goes_on = true;
    while (goes_on && (updates == 0 || result.updates < updates)) {
        clock.wait();
        goes_on = cockpit.update(clock.overruns());
        for (std::uint32_t field = 1; field < fields; ++field) {
            clock.wait();
            cockpit.show(field);
        }
        ++result.updates;
    }
    result.overruns = clock.overruns();
    return result;
}

} // namespace linkdig::tools
