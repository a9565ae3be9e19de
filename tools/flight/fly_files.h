#pragma once
/// A flight without a window: its frames as files.

#include "tools/display/retro_display.h"
#include "tools/flight/flight.h"

#include <cstdint>
#include <functional>
#include <string>

namespace linkdig::tools {

struct FilesRequest {
    std::string folder{};
    std::string name{};       ///< of the film, where the program can write one
    std::string heading{};    ///< over the contact sheet; the rest of the line is added
    std::uint64_t first = 0;  ///< number of the first frame
    std::uint64_t frames = 0; ///< at least 1
    std::uint32_t width = 0;  ///< of the pictures; 0: the machine's
    std::uint32_t height = 0;
};

/// Draws frames first to first + frames - 1 with `draw`, pictures of this size, and writes them as tools/flight/dump.h says. Prints what was
/// written.
void write_files(const FilesRequest& request, const ig::Configuration& configuration,
                 double frames_per_second, const std::function<const ig::VideoFrame&(std::uint64_t)>& draw);

/// The scenario's own flight, nobody at the controls; frames 0: all of it. `display`: shows the pictures field by field, a file
/// each; none: as they are.
void fly_as_files(Flight& flight, FilesRequest request, RetroDisplay* display = nullptr);

/// A line of what the flight cost.
void summarise(const Flight& flight, std::uint64_t overruns);

} // namespace linkdig::tools
