#pragma once
/// Which pixels count: rectangles and a mask picture.

#include "tools/compare/picture.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace linkdig::compare {

/// Pixels from the upper left corner of the frame; what reaches beyond it is cut off.
struct Rectangle {
    std::uint32_t x = 0, y = 0, width = 0, height = 0;
};

/// "X,Y,WIDTH,HEIGHT". Throws std::invalid_argument, saying what was expected.
Rectangle parse_rectangle(const std::string& text);

/// "R,G,B", 0 to 255 each, fractions allowed. Throws likewise.
std::array<double, 3> parse_colour(const std::string& text);

struct Regions {
    std::vector<Rectangle> include; ///< empty: everything
    std::vector<Rectangle> ignore;
    std::optional<Picture> mask; ///< pixels that are black in it (all channels 0) do not count
    bool everything() const { return include.empty() && ignore.empty() && !mask; }
};

/// A byte per pixel: 1 counts. Empty if everything counts.
std::vector<std::uint8_t> counted_pixels(const Regions& regions, std::uint32_t width, std::uint32_t height);

/// Empty, or why the mask cannot be laid over such a frame.
std::string mask_mistake(const Regions& regions, std::uint32_t width, std::uint32_t height);

} // namespace linkdig::compare
