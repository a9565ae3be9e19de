/// linkdig convert: a recording as text, a packet a line, and back.

#include "host/packet/recording_json.h"
#include "tools/compare/packet_stream.h"
#include "tools/flight/bad_input.h"
#include "tools/flight/output_name.h"
#include "tools/subcommands.h"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <string>

namespace linkdig::tools {
namespace {

struct ConvertOptions {
    std::string input;
    std::string output;
};

/// A name that says text for a recording, or the other way round, is a slip: of the command's two directions the input chooses.
void require_kind_of(const std::string& output, bool is_text) {
    const std::string ending = std::filesystem::path(output).extension().string();
    const bool named_text = ending == ".jsonl" || ending == ".json" || ending == ".txt";
    const bool named_recording = ending == ".rec" || ending == ".state";
    if (is_text ? named_recording : named_text)
        throw std::invalid_argument(fmt::format("'{}' cannot be written: its name is that of a {}, but of "
                                                "the input comes a {}; expected another one, "
                                                "as flight.{}",
                                                output, is_text ? "recording" : "text",
                                                is_text ? "text" : "recording", is_text ? "jsonl" : "rec"));
}

int convert(const ConvertOptions& options) {
    require_recording_name(options.output);
    require_other_file(options.output, options.input);
    if (std::filesystem::is_directory(options.input))
        throw BadInput("linkdig: error: " + options.input +
                       ": is a folder; expected a recording, or one as text");
    if (compare::has_recording_magic(options.input)) {
        require_kind_of(options.output, true);
        RecordingReader recording(options.input);
        recording_to_json(recording, options.output);
    } else {
        std::ifstream text(options.input);
        if (!text) throw BadInput(fmt::format("linkdig: error: {}: cannot be read", options.input));
        require_kind_of(options.output, false);
        try {
            json_to_recording(text, options.output);
        } catch (const RecordingTextMistake& mistake) {
            throw BadInput(fmt::format("linkdig: error: {}: {}", options.input, mistake.what()));
        }
    }
    fmt::print("{}: written\n", options.output);
    return ExitCode::done;
}

} // namespace

void add_convert(CLI::App& app, int& exit_code) {
    auto options = std::make_shared<ConvertOptions>();
    CLI::App* command = app.add_subcommand("convert", "Turn a recording into text, a packet a line, or back");
    command->add_option("input", options->input, "Recording, or its text (JSON, header first)")->required();
    command->add_option("-o,--output", options->output, "Text or recording to write")->required();
    command->footer("Example:\n  linkdig convert flight.rec -o flight.jsonl");
    command->callback([options, &exit_code] { exit_code = convert(*options); });
}

} // namespace linkdig::tools
