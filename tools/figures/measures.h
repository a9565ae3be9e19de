#pragma once
/// Measures of pictures: numbers that say what an eye would.

#include "ig/video/line.h"

#include <cstdint>
#include <span>
#include <vector>

namespace linkdig::tools {

/// Green of a pixel, 0 to 255: the sea's colour code has it neither highest nor
/// lowest.
inline int level(std::uint32_t pixel) { return static_cast<int>((pixel >> 8U) & 0xFFU); }

/// Root mean square of the difference of neighbouring pixels, in levels, where
/// both are in the mask.
double rms_gradient(const ig::VideoFrame& picture, std::span<const std::uint8_t> mask);

/// The largest difference, in levels, of two neighbouring pixels of different
/// faces, where both are in the mask and lie in the rows from `first_row` on.
/// Wants the rank plane.
int greatest_step(const ig::VideoFrame& picture, std::span<const std::uint8_t> mask, std::uint32_t first_row);

/// Root mean square of what changed in the intensity planes from one picture
/// to another, in levels of 255, where the mask is. Not of the pixels: their
/// rounding to whole levels is as much as a small step itself.
double rms_change(const ig::VideoFrame& before, const ig::VideoFrame& after,
                  std::span<const std::uint8_t> mask);

/// Mean intensity of each row (intensity plane), 0 to 1.
std::vector<double> row_means(const ig::VideoFrame& picture);

/// By how many elements `later` is `first` moved on: where their correlation
/// (of what both have, means taken off) is greatest, to a fraction of an
/// element. At most `most` either way.
double shift(std::span<const double> first, std::span<const double> later, int most);

/// Second moments of the intensity plane's gradient, and with `after` the one
/// motion in pixels a frame that explains the change best (least squares over
/// all pixels).
struct Flow {
    double xx = 0.0, xy = 0.0, yy = 0.0;
    double right = 0.0, down = 0.0;
    /// Greater over smaller eigenvalue of the moments: 1 where no direction is
    /// preferred.
    double anisotropy() const;
};
Flow flow(const ig::VideoFrame& picture, const ig::VideoFrame& after);

} // namespace linkdig::tools
