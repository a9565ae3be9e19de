#pragma once
/// A frame's pictures as a browser shows them.

#include "tools/compare/compare.h"

#include <cstdint>
#include <span>
#include <vector>

namespace linkdig::compare {

/// An 8-bit PNG in memory: colours as they are (floats clamped to 0 to 1), numbers that name things each in a
/// colour of its own. Throws std::runtime_error if OpenImageIO cannot.
std::vector<std::uint8_t> browser_png(const Picture& picture);

/// The difference as grey levels, amplified until the largest is white; what does not differ is black.
std::vector<std::uint8_t> difference_png(std::span<const float> levels, std::uint32_t width,
                                         std::uint32_t height, double gain);

/// Fills details' three PNGs and gain. The frame's pictures must be there.
void add_pictures(std::span<const float> levels, FrameResult& frame);

} // namespace linkdig::compare
