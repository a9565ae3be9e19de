#pragma once
/// A square grid of heights, and the sums that make one.

#include "database/model/vectors.h"

#include <cstdint>
#include <vector>

namespace linkdig::database {

/// Cell (column, row) has its middle at origin + cell (column + 1/2, row + 1/2); rows run to +y.
struct WaveField {
    std::uint32_t size = 0;     ///< cells a side
    double cell = 1.0;          ///< side of a cell, units
    Vec2d origin{0};            ///< its corner of least x and y
    std::vector<float> heights; ///< size x size, row by row
};

/// Bilinear splats into a grid, in fixed point: the sum does not depend on the order, so threads do not change it.
class SplatGrid {
public:
    /// `one`: what a unit of height is held as, a power of two; all that may come together in a cell must stay under 2^62.
    SplatGrid(std::uint32_t size, double cell, const Vec2d& origin, double one)
        : size_(size), cell_(cell), per_cell_(1.0 / cell), origin_(origin), one_(one),
          sums_(std::size_t{size} * size) {}

    /// Adds `amount` (heights times `one`) to the four cells around the point by their distance; false if the point is not
    /// between the middles of four cells.
    bool add(double x, double y, double amount) {
        const double column = (x - origin_.x) * per_cell_ - 0.5;
        const double row = (y - origin_.y) * per_cell_ - 0.5;
        const double last = static_cast<double>(size_ - 1);
        if (!(column >= 0.0 && row >= 0.0 && column < last && row < last)) return false;
        const auto i = static_cast<std::int64_t>(column);
        const auto j = static_cast<std::int64_t>(row);
        const double right = column - static_cast<double>(i);
        const double up = row - static_cast<double>(j);
        std::int64_t* const at = &sums_[static_cast<std::size_t>(j * size_ + i)];
        const double upper = amount * up;
        const double lower = amount - upper;
        const double lower_right = lower * right;
        const double upper_right = upper * right;
        at[0] += static_cast<std::int64_t>(lower - lower_right);
        at[1] += static_cast<std::int64_t>(lower_right);
        at[size_] += static_cast<std::int64_t>(upper - upper_right);
        at[size_ + 1] += static_cast<std::int64_t>(upper_right);
        return true;
    }

    void add(const SplatGrid& other);
    WaveField field() const;

private:
    std::int64_t size_;
    double cell_;
    double per_cell_;
    Vec2d origin_;
    double one_;
    std::vector<std::int64_t> sums_;
};

/// Slope in the middle of a cell, by the heights beside it; at the border by the cell's own.
Vec2d slope_at(const WaveField& field, std::uint32_t column, std::uint32_t row);

/// Root mean square of the heights.
double rms_of(const WaveField& field);

/// Median height, up or down, of the cells that were written to (are not 0); 0 if none was.
double typical_height(const WaveField& field);

/// Rogues: cells that stick out of the range of their eight neighbours by more than eight times the typical height. A crest, however
/// short the wave, does not: it goes on in the next cell. Cells at the border are not looked at.
std::uint64_t rogue_cells(const WaveField& field);

/// The column's smoothing: every cell that was written to (is not 0) and is off the mean of its four neighbours by more than
/// `threshold` becomes that mean, all at once. Returns how many did. It takes short crests with the rogues.
std::uint64_t smooth_field(WaveField& field, double threshold);

/// The column's grey image: heights from least to greatest become 0 to 255; the first row is that of greatest y. A flat field is 128.
std::vector<std::uint8_t> grey_image(const WaveField& field);

} // namespace linkdig::database
