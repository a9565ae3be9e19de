#pragma once
/// A flight as files: a PNG per frame, a film and a contact sheet.

#include "ig/sink/sink.h"
#include "ig/video/line.h"

#include <cstdint>
#include <functional>
#include <string>

namespace linkdig::tools {

struct DumpRequest {
    std::string folder;       ///< made if it is missing
    std::string film_name;    ///< of the .mp4 file in the folder, without its ending; empty: no film
    std::string heading;      ///< over the contact sheet
    std::uint64_t first = 0;  ///< number of the first frame
    std::uint64_t frames = 0; ///< at least 1
    std::uint32_t frames_per_second = 30;
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    bool progress = false; ///< a line on stderr that says how far it is
};

/// Draws a frame of the flight. Called once for each frame, in order, never twice at a time; the picture need
/// only be valid until the next call.
using DrawFrame = std::function<const ig::VideoFrame&(std::uint64_t frame)>;

/// Draws frames `first` to `first` + `frames` - 1. Writes FOLDER/frame_000000.png ..., by their numbers, FOLDER/FILM.mp4 and FOLDER/contact.png. Pictures are written by other
/// threads while the next ones are drawn; what is written does not depend on how many there are. Throws
/// std::runtime_error, naming the file, if something cannot be written.
void dump_flight(const DumpRequest& request, const DrawFrame& draw);

} // namespace linkdig::tools
