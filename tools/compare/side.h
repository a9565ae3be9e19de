#pragma once
/// One side of a comparison: a picture, a folder of frames, or a recording whose frames are drawn.

#include "tools/compare/frame_name.h"
#include "tools/compare/recording.h"

#include <memory>
#include <string>
#include <vector>

namespace linkdig::compare {

enum class Kind : std::uint8_t { picture, folder, recording };

struct Entry {
    std::string name; ///< as told: the file's name, "frame 12", "frame 12 channel 1"
    std::string path; ///< of the file; empty: it is drawn
    FrameName key;
    std::uint64_t pass = 0;   ///< how often the frame numbers of a recording began again before it
    std::uint64_t packet = 0; ///< recordings: number of the packet from 0
    std::uint32_t channel = 0;
};

struct Side {
    Kind kind = Kind::picture;
    std::string path;
    std::vector<Entry> entries; ///< ascending by pass, number and series
    std::unique_ptr<Recording> recording;
};

/// Throws tools::BadInput, naming the path: nothing there, no frames in the folder, two files of one frame, a
/// recording that cannot be read or has no database. `frames_of` says what a recording is drawn with.
/// `may_be_empty`: a folder without frames is one whose references are still to be made.
Side open_side(const std::string& path, const FramesOf& frames_of, bool may_be_empty = false);

/// "a folder", "a recording" ...
const char* kind_text(Kind kind);

} // namespace linkdig::compare
