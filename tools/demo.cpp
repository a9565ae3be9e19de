/// linkdig demo: the shipped approach to LPH-2, in a window or as files.

#include "tools/flight/arguments.h"
#include "tools/flight/capacity_options.h"
#include "tools/flight/flight.h"
#include "tools/flight/fly_files.h"
#include "tools/flight/number_options.h"
#include "tools/flight/shipped_scenes.h"
#include "tools/fly/fly.h"
#include "tools/fly/window.h"
#include "tools/sheet/text.h"
#include "tools/subcommands.h"

#include <fmt/format.h>

#include <cstdio>
#include <memory>
#include <optional>
#include <string>

namespace linkdig::tools {
namespace {

struct DemoOptions {
    double seconds = 20.0;
    std::optional<std::uint64_t> frames;
    std::optional<std::string> size;
    std::string profile = "modern";
    bool no_smoothing = false;
    std::string display = "plain";
    std::optional<double> frames_per_second;
    bool headless = false;
    std::string out = "out/approach";
    std::uint32_t threads = 0;
    std::optional<std::uint64_t> seed;
    ig::Capacity capacity;
};

constexpr double headless_rate_hz = 30.0;

FlightRequest request_of(const DemoOptions& options, bool headless) {
    FlightRequest request;
    request.scenario_path = shipped_scenes() + "/first_flight/approach.toml";
    request.duration_s = options.seconds;
    request.seed = options.seed;
    request.configuration =
        configuration_of(options.profile, options.size, std::nullopt, options.threads, options.no_smoothing);
    request.configuration.capacity = options.capacity;
    const double rate_hz = headless ? headless_rate_hz : request.configuration.update_rate_hz;
    request.configuration.update_rate_hz = options.frames_per_second.value_or(rate_hz);
    return request;
}

std::unique_ptr<RetroDisplay> display_of(const DemoOptions& options, const ig::Configuration& built_as) {
    if (options.display != "retro") return nullptr;
    return std::make_unique<RetroDisplay>(built_as.raster, built_as.fields);
}

int write_demo(const DemoOptions& options) {
    require_fonts();
    Flight flight(request_of(options, true));
    fly_as_files(flight,
                 {.folder = options.out,
                  .name = "approach",
                  .heading = fmt::format("linkdig demo: {}", flight.scenario().name),
                  .frames = options.frames.value_or(0)},
                 display_of(options, flight.configuration()).get());
    summarise(flight, 0); // a virtual clock waits for every frame
    return ExitCode::done;
}

/// The window, or nothing if there is no display to open it on.
std::unique_ptr<Window> window_for(const ig::Configuration& configuration, const RetroDisplay* display) {
    if (!display_present()) return nullptr;
    try {
        return std::make_unique<Window>("linkdig demo",
                                        display ? display->width() : configuration.raster.width,
                                        display ? display->height() : configuration.raster.height);
    } catch (const std::runtime_error& error) {
        fmt::print(stderr, "linkdig demo: {}; files are written instead\n", error.what());
        return nullptr;
    }
}

int run(const DemoOptions& options) {
    const FlightRequest request = request_of(options, false);
    const auto display = display_of(options, request.configuration);
    const auto window = options.headless ? nullptr : window_for(request.configuration, display.get());
    if (!window) return write_demo(options);
    Flight flight(request);
    const FlyResult flown = fly(flight, *window, {.updates = options.frames.value_or(0)}, display.get());
    summarise(flight, flown.overruns);
    return ExitCode::done;
}

} // namespace

void add_demo(CLI::App& app, int& exit_code) {
    auto options = std::make_shared<DemoOptions>();
    CLI::App* demo = app.add_subcommand("demo", "Fly the shipped approach to LPH-2 over a moving sea");
    demo->add_option("--seconds", options->seconds, "Length of the flight; 60: from half a mile")
        ->check(finite_number(0.1, 86400.0))
        ->capture_default_str();
    demo->add_option("--frames", options->frames, "Draw this many frames, whatever the length of the flight")
        ->check(CLI::Range(1, 1000000));
    demo->add_option("--size", options->size, "Picture, WIDTHxHEIGHT pixels; default: the profile's");
    demo->add_flag("--no-smoothing", options->no_smoothing,
                   "Show faces by pixel centres, without smoothed edges");
    demo->add_option("--profile", options->profile, "Machine profile")
        ->check(CLI::IsMember({"ames", "modern"}))
        ->capture_default_str();
    demo->add_option("--display", options->display,
                     "plain, or retro: a monitor of the period, field by field, twice as large")
        ->check(CLI::IsMember({"plain", "retro"}))
        ->capture_default_str();
    demo->add_option("--fps", options->frames_per_second,
                     "Updates a second; default: 30 headless, the profile's in a window")
        ->check(CLI::Range(1, 240));
    demo->add_flag("--headless", options->headless, "Write files, even where there is a display");
    demo->add_option("--out", options->out, "Folder of the files")->capture_default_str();
    demo->add_option("--threads", options->threads,
                     "Threads of the image generator; 0: as many as the machine has")
        ->check(CLI::Range(0, 256));
    add_capacity_options(*demo, options->capacity);
    demo->add_option("--seed", options->seed, "Seed of the flight; default: the scenario's")
        ->transform(whole_number());
    demo->footer(
        "In a window the keys are shown on the screen. Without a display, or with --headless, the flight is\n"
        "written as PNG frames, approach.mp4 and contact.png.\n"
        "Example:\n  linkdig demo --headless --frames 600 --out out/approach");
    demo->callback([options, &exit_code] { exit_code = run(*options); });
}

} // namespace linkdig::tools
