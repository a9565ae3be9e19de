#include "tools/fly/fly.h"

#include "host/loop/frame_clock.h"
#include "host/loop/host_values.h"
#include "host/loop/instruments.h"
#include "host/loop/simulation_counter.h"
#include "host/loop/steady_rates.h"
#include "tools/flight/bad_input.h"
#include "tools/flight/saved_state.h"
#include "tools/fly/controls.h"
#include "tools/fly/status.h"
#include "tools/fly/window.h"
#include "tools/watch/database_reload.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

namespace linkdig::tools {
namespace {

using host::Signal;

/// What the picture on the screen was drawn from.
struct Shown {
    std::uint64_t frame = 0;
    host::SignalValues signals;
    bool of_1980 = false;
    bool operator==(const Shown&) const = default;
};

/// A mistake as told on the screen, where it is plain who speaks.
std::string on_screen(std::string told) {
    constexpr std::string_view speaker = "linkdig: error: ";
    if (told.starts_with(speaker)) told.erase(0, speaker.size());
    return told;
}

class Cockpit {
public:
    Cockpit(Flight& flight, Window& window, const FlyRequest& request, RetroDisplay* display)
        : flight_(flight), window_(window), request_(request), display_(display),
          today_(flight.configuration()),
          signals_(request.signals != nullptr ? *request.signals : own_signals_),
          indications_(request.indications != nullptr ? *request.indications : own_indications_),
          instruments_(flight.loop()), recordings_(request.record),
          reload_(flight.scenario().database_path, flight.database_files()) {
        screen_.panel = request.panel;
        text_[1].corner = TextBlock::Corner::bottom_left;
        if (request.record_all) recordings_.follow(true, flight);
    }

    /// One update, `slots` after the one before; false when somebody has quit.
    bool update(std::uint64_t slots, std::uint64_t overruns) {
        take_controls();
        look_at_database();
        const host::SignalValues now =
            rates_.follow(signals_.snapshot(), flight_.loop(), counter_.frame(), signals_);
        const std::uint64_t frame = counter_.next(now, slots);
        if (screen_.of_1980 != (shown_ && shown_->of_1980)) change_profile();
        follow_recording(now);
        const Shown wanted{updated(frame), without_pulses(now), screen_.of_1980};
        if (shown_ != wanted) draw(wanted, overruns);
        instruments_.read(flight_.loop(), flight_.packet(), overruns, indications_);
        if (std::exchange(screen_.save_state, false)) save();
        if (std::exchange(screen_.load_state, false)) load();
        if (std::exchange(screen_.switch_effect, false)) switch_effect(wanted);
        write_text();
        show(0);
        return !screen_.quit;
    }

    /// A field of the picture that was drawn last; a display is built for the pictures of one profile.
    void show(std::uint32_t field) {
        const auto selected = static_cast<std::size_t>(shown_->signals[Signal::channel_select]);
        const std::size_t channel = std::min(selected, flight_.loop().channels() - 1);
        const ig::VideoFrame& picture = flight_.machine().picture(channel);
        const bool plain = display_ == nullptr || screen_.of_1980;
        window_.show(plain ? picture : display_->show(picture, field), text_);
    }

    const std::vector<Recorded>& finish() { return recordings_.finish(); }

private:
    void take_controls() {
        const bool by_hand = signals_.value(Signal::hands_on) != 0.0 || flies_by_hand();
        for (const Action action : window_.actions())
            if (!by_hand || !is_stick(action)) apply(action, flight_.loop(), signals_, screen_);
        if (!by_hand) return;
        const Sticks sticks = window_.sticks();
        signals_.write(Signal::stick_fore, sticks.fore);
        signals_.write(Signal::stick_right, sticks.right);
        signals_.write(Signal::pedals_right, sticks.pedals_right);
        signals_.write(Signal::collective, sticks.collective);
    }
    bool flies_by_hand() const {
        return flight_.scenario().own_ship.kind == host::OwnShipSection::Kind::flown;
    }
    /// While flying by hand the arrow keys are the stick.
    static bool is_stick(Action action) {
        return action >= Action::sun_up && action <= Action::sea_sun_faster;
    }

    /// The author has saved: the flight goes on, over what the files say now. Its frame is drawn anew, frozen or not.
    void look_at_database() {
        std::optional<DatabaseReload::Outcome> outcome = reload_.poll();
        if (!outcome) return;
        if (!outcome->database) return refuse_database(outcome->refused);
        if (recordings_.active()) {
            told_ = "the database has changed; this recording keeps the one that it began with";
            return;
        }
        try {
            flight_.replace_database(std::move(*outcome->database));
        } catch (const BadInput& lacking) {
            return refuse_database(lacking.what());
        }
        shown_.reset();
        before_.clear();
        prices_ = {};
        told_ = fmt::format("{} opened again: {} faces", flight_.database().name,
                            flight_.database().faces.size());
        fmt::print(stderr, "{}\n", told_);
    }
    /// All of it goes where there is room for it, the first line on the screen.
    void refuse_database(const std::string& why) {
        fmt::print(stderr, "{}{}", why, why.ends_with('\n') ? "" : "\n");
        told_ = "the database stays: " + on_screen(why.substr(0, why.find('\n')));
    }

    /// The frame that this update shows: of 1980 every second one is drawn, at 30 updates a second.
    std::uint64_t updated(std::uint64_t frame) const {
        if (!screen_.of_1980) return frame;
        const double ratio = flight_.loop().update_rate_hz() / ig::ames_profile().update_rate_hz;
        const auto step = static_cast<std::uint64_t>(std::max(1L, std::lround(ratio)));
        return frame / step * step;
    }

    /// What cannot be written does not end the flight.
    void follow_recording(const host::SignalValues& now) {
        try {
            recordings_.follow(request_.record_all || now.on(Signal::record), flight_);
        } catch (const std::runtime_error& refused) {
            signals_.write(Signal::record, 0.0);
            told_ = refused.what();
        }
    }

    void change_profile() {
        ig::Configuration configuration = today_;
        if (screen_.of_1980) {
            configuration = ig::ames_profile();
            configuration.threads = today_.threads;
        }
        flight_.rebuild(configuration);
    }

    void draw(const Shown& wanted, std::uint64_t overruns) {
        const bool next = !shown_ || shown_->frame != wanted.frame;
        before_ = next ? flight_.history() : before_;
        flight_.machine().measure_stages(true);
        report_ = flight_.draw(wanted.frame, wanted.signals);
        report_.overruns = overruns;
        if (next) recordings_.write(flight_.packet());
        shown_ = wanted;
    }

    void save() {
        save_state(request_.state, flight_, before_);
        told_ = fmt::format("saved in {}", request_.state);
    }

    void load() {
        try {
            const SavedState state = load_state(request_.state, flight_.database_id());
            report_ = flight_.resume(state.packet, state.history);
            const host::SignalValues signals = host::signals_of(state.packet);
            take_over(signals);
            counter_.resume(state.packet.frame);
            shown_ = Shown{state.packet.frame, standing(signals_), screen_.of_1980};
            told_ = fmt::format("frame {} of {}", state.packet.frame, request_.state);
        } catch (const BadInput& refused) {
            told_ = on_screen(refused.what());
        }
    }

    /// All signals of a saved state, except whether this flight is recorded.
    void take_over(host::SignalValues signals) {
        signals.set(Signal::record, signals_.value(Signal::record));
        signals_.assign(signals);
        rates_.resume(signals);
    }

    void switch_effect(const Shown& wanted) {
        const auto effect = static_cast<Effect>(screen_.effect);
        if (!is_possible(effect, flight_.loop())) {
            told_ = fmt::format("the database has nothing for \"{}\"", effect_name(effect));
            return;
        }
        const bool on = is_on(effect, wanted.signals, flight_.loop());
        const host::SignalValues changed = switched(effect, !on, wanted.signals, flight_.loop());
        for (const host::SignalDefinition& each : host::signal_directory())
            if (each.kind != host::SignalKind::pulse) signals_.write(each.signal, changed[each.signal]);
        prices_[screen_.effect] = price_of(effect, flight_, wanted.frame, standing(signals_));
    }

    /// A picture that stands has text that stands: its figures are those of the frame that was drawn.
    void write_text() {
        text_[0].lines =
            screen_.help || screen_.all_keys ? help_lines(screen_.all_keys) : std::vector<std::string>{};
        auto& foot = text_[1].lines;
        foot.clear();
        if (!told_.empty()) foot.push_back(told_);
        if (screen_.panel) put_panel(foot);
        for (std::string& line : status_lines(flight_.database(), flight_.packet(), report_, shown_->signals))
            foot.push_back(std::move(line));
    }

    void put_panel(std::vector<std::string>& lines) const {
        for (std::string& line : load_lines(flight_, report_))
            lines.push_back(std::move(line));
        lines.push_back(stage_line(flight_.machine().stage_times()));
        for (std::string& line : method_lines(flight_.loop(), shown_->signals))
            lines.push_back(std::move(line));
        for (std::string& line : sun_lines(flight_.database(), flight_.packet()))
            lines.push_back(std::move(line));
        for (std::size_t i = 0; i < effect_count; ++i)
            lines.push_back((i == screen_.effect ? "> " : "  ") +
                            effect_line(static_cast<Effect>(i), shown_->signals, flight_.loop(), prices_[i]));
    }

    Flight& flight_;
    Window& window_;
    const FlyRequest& request_;
    RetroDisplay* display_; ///< none: the picture as it is
    const ig::Configuration today_;
    host::SignalStore own_signals_;
    host::SignalStore& signals_;
    host::IndicationStore own_indications_;
    host::IndicationStore& indications_;
    host::SteadyRates rates_;
    host::Instruments instruments_;
    host::SimulationCounter counter_;
    Screen screen_;
    std::array<TextBlock, 2> text_; ///< help, status
    std::optional<Shown> shown_;
    std::vector<std::uint8_t> before_; ///< the machine's history before the frame on the screen
    FrameReport report_;
    std::array<std::optional<Price>, effect_count> prices_;
    std::string told_;
    Recordings recordings_;
    DatabaseReload reload_;
};

} // namespace

FlyResult fly(Flight& flight, Window& window, const FlyRequest& request, RetroDisplay* display) {
    Cockpit cockpit(flight, window, request, display);
    const std::uint32_t fields = display == nullptr ? 1 : display->fields();
    const auto time = host::steady_time();
    host::FrameClock clock(flight.loop().update_rate_hz() * fields, *time);
    FlyResult result;
    std::uint64_t slot = 0;
    bool goes_on = true;
    while (goes_on && (request.updates == 0 || result.updates < request.updates)) {
        const std::uint64_t running = clock.wait();
        const std::uint64_t update = running / fields;
        goes_on = cockpit.update(update - slot, clock.overruns());
        slot = update;
        for (std::uint32_t field = 1; field < fields; ++field) {
            clock.wait();
            cockpit.show(field);
        }
        ++result.updates;
    }
    result.overruns = clock.overruns();
    result.recordings = cockpit.finish();
    return result;
}

} // namespace linkdig::tools
