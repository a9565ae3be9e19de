#pragma once
/// The binary as a person runs it.

#include "tests/tools/pictures.h"

#include <array>
#include <cstdio>
#include <string>
#include <sys/wait.h>

namespace linkdig::tools {

struct Outcome {
    int exit_code = -1;
    std::string output;
    std::string errors;
};

/// Runs the binary as a person would, without a display.
inline Outcome run(const std::string& arguments) {
    const TemporaryFolder folder;
    const std::string errors = folder.file("errors");
    const std::string command = "env -u DISPLAY -u WAYLAND_DISPLAY -u SDL_VIDEODRIVER '" LINKDIG_BINARY "' " +
                                arguments + " 2>" + errors;
    Outcome outcome;
    FILE* pipe = popen(command.c_str(), "r");
    std::array<char, 4096> buffer{};
    while (pipe != nullptr && std::fgets(buffer.data(), buffer.size(), pipe) != nullptr)
        outcome.output += buffer.data();
    if (pipe != nullptr) outcome.exit_code = WEXITSTATUS(pclose(pipe));
    outcome.errors = bytes_of(errors);
    return outcome;
}

} // namespace linkdig::tools
