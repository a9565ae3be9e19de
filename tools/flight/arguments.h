#pragma once
/// Values of command lines that several subcommands take.

#include "ig/configuration.h"

#include <cstdint>
#include <optional>
#include <string>

namespace linkdig::tools {

struct PictureSize {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
};

/// "1280x720". Each side 16 to 4096. Throws std::invalid_argument, saying what was expected.
PictureSize parse_size(const std::string& text);

/// Frames first to last, both included.
struct FrameRange {
    std::uint64_t first = 0;
    std::uint64_t last = 0;
};

/// "10:20", or "10" for that frame alone. Throws std::invalid_argument, saying what was expected.
FrameRange parse_frames(const std::string& text);

/// The machine that --profile, --size, --fps and --threads ask for, its edges smoothed unless --no-smoothing is given. Throws as parse_size() does.
ig::Configuration configuration_of(const std::string& profile, const std::optional<std::string>& size,
                                   std::optional<double> frames_per_second, std::uint32_t threads,
                                   bool no_smoothing);

} // namespace linkdig::tools
