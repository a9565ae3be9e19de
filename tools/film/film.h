#pragma once
/// A film of pictures: an .mp4 file through libavcodec, one thread, bit-exact, so that files repeat.

#include "ig/video/line.h"

#include <cstdint>
#include <memory>
#include <string>

namespace linkdig::tools {

/// Was this program built with video files (CMake option LINKDIG_VIDEO_FILES)?
bool video_files();

class Film {
public:
    /// Opens the file. Pictures of odd size lose their last column or row: the colour of the format is kept
    /// for 2 x 2 pixels. `frames_per_second` is 1 to 240. Throws std::runtime_error, naming what was tried,
    /// if it cannot be written, or if the program was built without video files.
    Film(const std::string& path, std::uint32_t width, std::uint32_t height, std::uint32_t frames_per_second);
    /// A film that was not finished is left behind incomplete.
    ~Film();
    Film(const Film&) = delete;
    Film& operator=(const Film&) = delete;

    /// Adds the next picture, of the size given to the constructor. Throws likewise.
    void add(const ig::VideoFrame& picture);
    /// Writes what the encoder still holds and closes the file. Throws likewise.
    void finish();

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace linkdig::tools
