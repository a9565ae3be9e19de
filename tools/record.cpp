/// linkdig record: the packets of a scenario's flight, as a recording; nothing is drawn.

#include "database/format/name_directory.h"
#include "host/packet/recording.h"
#include "tools/flight/arguments.h"
#include "tools/flight/flight.h"
#include "tools/flight/output_name.h"
#include "tools/flight/saved_state.h"
#include "tools/subcommands.h"

#include <fmt/format.h>

#include <memory>
#include <optional>
#include <string>

namespace linkdig::tools {
namespace {

struct RecordOptions {
    std::string scenario;
    std::string output;
    std::string state;
    std::optional<std::uint64_t> frames;
    std::optional<std::string> size;
    double frames_per_second = 30.0;
};

int record(const RecordOptions& options) {
    require_recording_name(options.output);
    require_other_file(options.output, options.state);
    FlightRequest request;
    request.scenario_path = options.scenario;
    request.configuration = configuration_of("modern", options.size, options.frames_per_second, 0, false);
    Flight flight(request);
    host::SignalValues signals;
    std::uint64_t first = 0;
    std::vector<std::uint8_t> history;
    if (!options.state.empty()) {
        SavedState state = load_state(options.state, flight.database_id());
        signals = flight.resume_host(state.packet);
        first = state.packet.frame;
        history = std::move(state.history);
    }
    RecordingWriter recording(options.output, flight.recording_header(), history);
    const std::uint64_t frames = options.frames.value_or(flight.loop().frames());
    for (std::uint64_t frame = first; frame < first + frames; ++frame)
        recording.write(flight.packet_of(frame, signals));
    recording.close();
    fmt::print("{}: {} packets at {:g} Hz\n", options.output, recording.packets(),
               flight.loop().update_rate_hz());
    return ExitCode::done;
}

} // namespace

void add_record(CLI::App& app, int& exit_code) {
    auto options = std::make_shared<RecordOptions>();
    CLI::App* command =
        app.add_subcommand("record", "Write the packets of a scenario's flight as a recording");
    command->add_option("scenario", options->scenario, "Scenario file (.toml)")->required();
    command->add_option("-o,--output", options->output, "Recording to write")->required();
    command->add_option("--frames", options->frames, "So many frames; default: the whole scenario")
        ->check(CLI::Range(1, 10000000));
    command->add_option(
        "--size", options->size,
        "Picture that the views are made for, WIDTHxHEIGHT pixels: its shape counts; default: the "
        "profile's, 1024x1024");
    command->add_option("--state", options->state, "Begin where a saved state stands, with its signals");
    command->add_option("--fps", options->frames_per_second, "Frames a second of simulated time")
        ->check(CLI::Range(1, 240))
        ->capture_default_str();
    command->footer("Example:\n  linkdig record database/scenes/first_flight/approach.toml -o approach.rec");
    command->callback([options, &exit_code] { exit_code = record(*options); });
}

} // namespace linkdig::tools
