#pragma once
/// What is told of the few frames that are looked at closely.

#include "tools/compare/compare.h"

#include <span>
#include <string>

namespace linkdig::compare {

/// Fills frame.details, and lets the frame's pictures go. `perceptual`: that figure too, which takes seconds.
void add_details(const Case& which, const Settings& settings, bool perceptual, FrameResult& frame);

/// At most 64 x 24 cells, a row of text each: the largest difference in a cell as ' ' none, '.' up to 1
/// level, ':' 4, '+' 16, 'x' 64, '#' more.
std::string character_map(std::span<const float> levels, std::uint32_t width, std::uint32_t height);

/// How many pixels a viewer tells apart, by Yee's metric (OpenImageIO's compare_Yee: a picture of 100 cd/m^2
/// that fills 45 degrees). Nothing for pictures that name things or have no three channels.
std::optional<std::uint64_t> perceptual_difference(const Picture& expected, const Picture& actual);

} // namespace linkdig::compare
