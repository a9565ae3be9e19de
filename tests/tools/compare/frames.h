#pragma once
/// Frames on disk that the tests of linkdig compare share.

#include "tests/tools/command.h"

#include <OpenImageIO/imageio.h>
#include <nlohmann/json.hpp>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace linkdig::tools {

/// An 8-bit picture in memory, to be spoilt.
struct Frame {
    int width = 0, height = 0, channels = 3;
    std::vector<std::uint8_t> samples;
    std::uint8_t& at(int x, int y, int c) {
        return samples[static_cast<std::size_t>((y * width + x) * channels + c)];
    }
};

/// Squares of changing colour with a gradient in them: no two rows or columns alike.
inline Frame test_frame(int width, int height, unsigned seed = 0) {
    Frame frame{width, height, 3, std::vector<std::uint8_t>(static_cast<std::size_t>(width * height * 3))};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (int c = 0; c < 3; ++c)
                frame.at(x, y, c) = static_cast<std::uint8_t>(
                    (x / 8 * 40 + y / 8 * 70 + c * 50 + x + y * 2 + static_cast<int>(seed) * 13) % 200 + 20);
    return frame;
}

/// Writes with OpenImageIO itself, so that the product's writer and reader are not both ours.
inline void write_frame(const std::string& path, const Frame& frame,
                        OIIO::TypeDesc type = OIIO::TypeDesc::UINT8) {
    OIIO::ImageSpec spec(frame.width, frame.height, frame.channels, type);
    const auto output = OIIO::ImageOutput::create(path);
    output->open(path, spec);
    output->write_image(OIIO::TypeDesc::UINT8, frame.samples.data());
    output->close();
}

/// Frames 1 to `count` as FOLDER/PREFIX0001.png ...
inline void write_sequence(const std::string& folder, const std::string& prefix, unsigned count) {
    std::filesystem::create_directories(folder);
    for (unsigned k = 1; k <= count; ++k) {
        std::string number = std::to_string(k);
        number.insert(0, 4 - number.size(), '0');
        write_frame(folder + "/" + prefix + number + ".png", test_frame(40, 30, k));
    }
}

inline std::string in_quotes(const std::string& path) { return "'" + path + "'"; }

inline nlohmann::json json_of(const Outcome& outcome) {
    return nlohmann::json::parse(outcome.output, nullptr, false);
}

inline void cut_file(const std::string& path, std::uintmax_t bytes) {
    std::filesystem::resize_file(path, bytes);
}

} // namespace linkdig::tools
