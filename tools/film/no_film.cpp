#include "tools/film/film.h"

#include <stdexcept>

namespace linkdig::tools {

struct Film::State {};

bool video_files() { return false; }

Film::Film(const std::string& path, std::uint32_t, std::uint32_t, std::uint32_t) {
    throw std::runtime_error(path +
                             ": cannot be written: built without video files (LINKDIG_VIDEO_FILES=OFF)");
}

Film::~Film() = default;
void Film::add(const ig::VideoFrame&) {}
void Film::finish() {}

} // namespace linkdig::tools
