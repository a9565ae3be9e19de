/// linkdig fly: a scenario, in a window or as files.

#include "tools/fly/fly.h"
#include "host/panel/panel_link.h"
#include "tools/flight/arguments.h"
#include "tools/flight/bad_input.h"
#include "tools/flight/fly_files.h"
#include "tools/flight/output_name.h"
#include "tools/fly/window.h"
#include "tools/panel/shipped_mappings.h"
#include "tools/sheet/text.h"
#include "tools/subcommands.h"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace linkdig::tools {
namespace {

struct FlyOptions {
    std::string scenario;
    std::optional<std::uint64_t> frames;
    std::optional<std::string> size;
    std::string profile = "modern";
    std::optional<double> frames_per_second;
    bool headless = false;
    std::string out = "out/flight";
    std::optional<std::string> record;
    std::string state = "linkdig.state";
    std::uint32_t threads = 0;
    bool panel = false;
    std::vector<std::string> mappings;
};

/// The cockpit panels of a flight.
struct Panels {
    Panels(const std::vector<std::string>& mapping_files, host::SignalStore& signals,
           const host::IndicationStore& indications)
        : tell([](const std::string& words) { fmt::print(stderr, "panel: {}\n", words); }),
          desk(mappings_of(mapping_files), signals, indications, tell), link(desk, tell) {}
    panel::Tell tell;
    panel::PanelDesk desk;
    panel::PanelLink link;
};

FlightRequest request_of(const FlyOptions& options) {
    FlightRequest request;
    request.scenario_path = options.scenario;
    request.configuration =
        configuration_of(options.profile, options.size, options.frames_per_second, options.threads, false);
    if (options.headless && !options.frames_per_second) request.configuration.update_rate_hz = 30.0;
    return request;
}

int as_files(const FlyOptions& options) {
    if (options.record)
        throw std::invalid_argument("--record keeps what is flown in a window; linkdig record needs none");
    if (options.panel)
        throw std::invalid_argument("--panel needs a window; files are flown as the scenario says");
    require_fonts();
    Flight flight(request_of(options));
    fly_as_files(flight, {.folder = options.out,
                          .name = std::filesystem::path(options.scenario).stem().string(),
                          .heading = fmt::format("linkdig fly: {}", flight.scenario().name),
                          .frames = options.frames.value_or(0)});
    summarise(flight, 0); // a virtual clock waits for every frame
    return ExitCode::done;
}

int run(const FlyOptions& options) {
    if (options.record) require_recording_name(*options.record);
    require_recording_name(options.state);
    if (options.headless) return as_files(options);
    host::SignalStore signals;
    host::IndicationStore indications;
    std::optional<Panels> panels;
    const FlightRequest request = request_of(options);
    Flight flight(request);
    Window window("linkdig fly: " + flight.scenario().name, request.configuration.raster.width,
                  request.configuration.raster.height);
    FlyRequest flown_as{.updates = options.frames.value_or(0), .state = options.state, .panel = true};
    if (options.record) {
        flown_as.record = *options.record;
        flown_as.record_all = true;
    }
    flown_as.signals = &signals;
    flown_as.indications = &indications;
    if (options.panel) panels.emplace(options.mappings, signals, indications);
    const FlyResult flown = fly(flight, window, flown_as);
    summarise(flight, flown.overruns);
    for (const Recorded& each : flown.recordings)
        fmt::print("{}: {} packets\n", each.path, each.packets);
    return ExitCode::done;
}

} // namespace

void add_fly(CLI::App& app, int& exit_code) {
    auto options = std::make_shared<FlyOptions>();
    CLI::App* command = app.add_subcommand("fly", "Fly a scenario, in a window or as files");
    command->add_option("scenario", options->scenario, "Scenario file (.toml)")->required();
    command->add_flag("--headless", options->headless, "Write PNG frames, a film and a contact sheet");
    command
        ->add_option("--frames", options->frames,
                     "Draw this many frames; default: the scenario's, or until quit")
        ->check(CLI::Range(1, 1000000));
    command->add_option("--out", options->out, "Folder of the files")->capture_default_str();
    command->add_option("--record", options->record,
                        "Keep the whole flight in this recording, whatever the signal \"record\" says");
    command
        ->add_option_function<std::vector<std::string>>(
            "--panel",
            [options](const std::vector<std::string>& files) {
                options->panel = true;
                for (const std::string& file : files)
                    if (!file.empty()) options->mappings.push_back(file);
            },
            "Fly with the cockpit panels on USB, by these mapping files; without any by the shipped ones")
        ->expected(0, 16)
        ->type_name("[MAPPING ...]")
        ->trigger_on_parse(false);
    command->add_option("--state", options->state, "File of the keys F9 and F10")->capture_default_str();
    command->add_option("--size", options->size, "Picture, WIDTHxHEIGHT pixels; default: the profile's");
    command->add_option("--profile", options->profile, "Machine profile")
        ->check(CLI::IsMember({"ames", "modern"}))
        ->capture_default_str();
    command
        ->add_option("--fps", options->frames_per_second,
                     "Updates a second; default: 30 headless, the profile's in a window")
        ->check(CLI::Range(1, 240));
    command
        ->add_option("--threads", options->threads,
                     "Threads of the image generator; 0: as many as the machine has")
        ->check(CLI::Range(0, 256));
    command->footer(
        "In a window F1 shows all keys; a joystick flies by hand once its first button is pressed.\n"
        "Example:\n  linkdig fly database/scenes/first_flight/approach.toml --record flight.rec");
    command->callback([options, &exit_code] { exit_code = run(*options); });
}

} // namespace linkdig::tools
