#pragma once
/// Two pictures against each other, explained in the terminal.

#include "ig/video/line.h"

#include <cstdint>
#include <string>

namespace linkdig::support {

struct PictureDifference {
    std::uint32_t worst_level = 0;     ///< largest difference of a colour component, levels of 255
    std::uint64_t pixels = 0;          ///< how many differ at all
    std::uint64_t ranks = 0;           ///< how many show another face
    std::int32_t worst_intensity = 0;  ///< largest difference of intensity, 1.0 = 2^22, where the ranks agree
    std::uint32_t column = 0, row = 0; ///< the worst pixel (of another rank if there is one)
    /// What differs, the worst pixel's values, and a map of where: '#' another face, '+' more than a level,
    /// '.' a level, ' ' equal. Empty if nothing differs.
    std::string explanation;
};

/// Compares pixels, and the planes that both have. Pictures of different size differ in every pixel.
PictureDifference compare(const ig::VideoFrame& expected, const ig::VideoFrame& actual);

} // namespace linkdig::support
