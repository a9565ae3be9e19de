/// linkdig convert: a recording as text, a packet a line, and back.

#include "host/packet/recording_json.h"
#include "tools/compare/packet_stream.h"
#include "tools/flight/bad_input.h"
#include "tools/subcommands.h"

#include <fmt/format.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>

namespace linkdig::tools {
namespace {

struct ConvertOptions {
    std::string input;
    std::string output;
};

[[noreturn]] void cannot_write(const std::string& path) {
    throw std::system_error(errno, std::generic_category(), "cannot write " + path);
}

/// The text gets its name when it is whole; a damaged recording leaves none.
void write_text(const ConvertOptions& options) {
    const std::string part = options.output + ".part";
    try {
        RecordingReader recording(options.input);
        errno = 0;
        std::ofstream text(part);
        if (!text) cannot_write(part);
        recording_to_json(recording, text);
        text.close();
        if (!text) cannot_write(part);
        std::filesystem::rename(part, options.output);
    } catch (...) {
        std::error_code gone_already;
        std::filesystem::remove(part, gone_already);
        throw;
    }
}

int convert(const ConvertOptions& options) {
    if (std::filesystem::is_directory(options.input))
        throw BadInput(options.input + ": error: is a folder; expected a recording, or one as text");
    if (compare::has_recording_magic(options.input)) {
        write_text(options);
    } else {
        std::ifstream text(options.input);
        if (!text) throw BadInput(fmt::format("{}: error: cannot be read", options.input));
        try {
            json_to_recording(text, options.output);
        } catch (const std::runtime_error& mistake) {
            if (!std::string_view(mistake.what()).starts_with("line ")) throw; // the file's, not the text's
            throw BadInput(fmt::format("{}: error: {}", options.input, mistake.what()));
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
