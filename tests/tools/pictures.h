#pragma once
/// Pictures and folders that the tools' tests share.

#include "ig/video/line.h"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <unistd.h>

namespace linkdig::tools {

/// A picture that no symmetry leaves alone: red runs to the right, green down, blue changes with `seed`.
inline ig::VideoFrame test_picture(std::uint32_t width, std::uint32_t height, std::uint32_t seed = 0) {
    ig::VideoFrame picture;
    picture.width = width;
    picture.height = height;
    for (std::uint32_t y = 0; y < height; ++y) {
        for (std::uint32_t x = 0; x < width; ++x) {
            const std::uint32_t red = x * 255 / width;
            const std::uint32_t green = y * 255 / height;
            const std::uint32_t blue = seed * 37 % 256;
            picture.pixels.push_back(red | green << 8U | blue << 16U | 0xFF000000U);
        }
    }
    return picture;
}

inline std::string bytes_of(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

/// A folder of its own, gone with the test.
class TemporaryFolder {
public:
    TemporaryFolder() {
        std::string pattern = (std::filesystem::temp_directory_path() / "linkdig-test-XXXXXX").string();
        path_ = mkdtemp(pattern.data());
    }
    ~TemporaryFolder() { std::filesystem::remove_all(path_); }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    std::string file(const std::string& name) const { return (path_ / name).string(); }
    std::string text() const { return path_.string(); }

private:
    std::filesystem::path path_;
};

} // namespace linkdig::tools
