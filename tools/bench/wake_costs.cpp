#include "tools/bench/wake_costs.h"

#include "tools/bench/measure.h"
#include "tools/flight/flight.h"
#include "tools/flight/shipped_scenes.h"

#include <memory>

namespace linkdig::bench {

namespace {

constexpr double begin_s = 100.0;
constexpr double rate_hz = 60.0;

/// A flight with some of the wakes.
struct Choice {
    WakeCost cost;
    host::SignalValues signals;
    std::unique_ptr<tools::Flight> flight;
    std::vector<double> making_ms, frame_ms;

    Choice(const char* made, bool kelvin, bool particles, const tools::FlightRequest& request)
        : flight(std::make_unique<tools::Flight>(request)) {
        cost.made = made;
        // The scenario has both: a signal switches one over.
        signals.set(host::Signal::kelvin, kelvin ? 0.0 : 1.0);
        signals.set(host::Signal::wave_particles, particles ? 0.0 : 1.0);
    }

    void draw(std::uint64_t frame) {
        const FrameReport& report = flight->draw(frame, signals);
        making_ms.push_back(1e3 * report.wakes_s);
        frame_ms.push_back(1e3 * flight->costs().last_machine_s);
        cost.faces = cost.particles = cost.edges = 0;
        for (const WakeReport& wake : report.wakes) {
            cost.faces += wake.faces;
            cost.particles += wake.particles;
        }
        for (const ChannelReport& channel : report.channels)
            cost.edges += channel.edges;
    }
};

} // namespace

std::vector<WakeCost> compare_wakes(std::uint32_t size, std::uint32_t threads, bool smoothing,
                                    std::uint32_t frames) {
    tools::FlightRequest request;
    request.scenario_path = tools::shipped_scenes() + "/two_ships/figure_of_eight.toml";
    request.configuration = ig::modern_profile();
    request.configuration.raster.width = request.configuration.raster.height = size;
    request.configuration.threads = threads;
    request.configuration.edge_smoothing = smoothing;
    request.configuration.update_rate_hz = rate_hz;
    std::vector<Choice> choices;
    choices.emplace_back("none", false, false, request);
    choices.emplace_back("kelvin", true, false, request);
    choices.emplace_back("wave_particles", false, true, request);
    choices.emplace_back("both", true, true, request);
    constexpr auto first = static_cast<std::uint64_t>(begin_s * rate_hz);
    for (Choice& choice : choices) {
        choice.flight->lead_in(first, choice.signals);
        choice.draw(first); // with its memory, which is not measured
        choice.making_ms.clear();
        choice.frame_ms.clear();
    }
    for (std::uint64_t frame = first + 1; frame <= first + frames; ++frame)
        for (Choice& choice : choices)
            choice.draw(frame);
    std::vector<WakeCost> costs;
    for (Choice& choice : choices) {
        choice.cost.making_ms = median(choice.making_ms);
        choice.cost.frame_ms = median(choice.frame_ms);
        costs.push_back(choice.cost);
    }
    return costs;
}

} // namespace linkdig::bench
