#include "database/water/wave_field.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace linkdig::database {

namespace {

/// Calls odd(cell, mean of its neighbours) for each cell that was written to and is off that mean.
template <typename Odd>
void for_each_odd_cell(const WaveField& field, double threshold, Odd odd) {
    const std::size_t side = field.size;
    for (std::size_t row = 1; row + 1 < side; ++row) {
        for (std::size_t column = 1; column + 1 < side; ++column) {
            const std::size_t at = row * side + column;
            const float* const h = &field.heights[at];
            if (*h == 0.0F) continue;
            const double mean = 0.25 * (static_cast<double>(h[1]) + static_cast<double>(*(h - 1)) +
                                        static_cast<double>(h[side]) + static_cast<double>(*(h - side)));
            if (std::fabs(static_cast<double>(*h) - mean) > threshold) odd(at, mean);
        }
    }
}

} // namespace

void SplatGrid::add(const SplatGrid& other) {
    for (std::size_t k = 0; k < sums_.size(); ++k)
        sums_[k] += other.sums_[k];
}

WaveField SplatGrid::field() const {
    WaveField field{static_cast<std::uint32_t>(size_), cell_, origin_, {}};
    field.heights.reserve(sums_.size());
    for (const std::int64_t sum : sums_)
        field.heights.push_back(static_cast<float>(static_cast<double>(sum) / one_));
    return field;
}

Vec2d slope_at(const WaveField& field, std::uint32_t column, std::uint32_t row) {
    const auto height = [&](std::uint32_t c, std::uint32_t r) {
        return static_cast<double>(field.heights[std::size_t{r} * field.size + c]);
    };
    const std::uint32_t last = field.size - 1;
    const std::uint32_t left = column > 0 ? column - 1 : 0;
    const std::uint32_t right = std::min(column + 1, last);
    const std::uint32_t below = row > 0 ? row - 1 : 0;
    const std::uint32_t above = std::min(row + 1, last);
    const double across = field.cell * std::max(1.0, static_cast<double>(right - left));
    const double up = field.cell * std::max(1.0, static_cast<double>(above - below));
    return {(height(right, row) - height(left, row)) / across,
            (height(column, above) - height(column, below)) / up};
}

double rms_of(const WaveField& field) {
    double sum = 0.0;
    for (const float h : field.heights)
        sum += static_cast<double>(h) * static_cast<double>(h);
    return field.heights.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(field.heights.size()));
}

double typical_height(const WaveField& field) {
    std::vector<float> heights;
    for (const float h : field.heights)
        if (h != 0.0F) heights.push_back(std::fabs(h));
    if (heights.empty()) return 0.0;
    const auto middle = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 2);
    std::ranges::nth_element(heights, middle);
    return static_cast<double>(*middle);
}

std::uint64_t rogue_cells(const WaveField& field) {
    constexpr double far_out = 8.0; // estimated: well-made wakes have no such cell
    const double threshold = far_out * typical_height(field);
    std::uint64_t count = 0;
    const std::size_t side = field.size;
    for (std::size_t row = 1; row + 1 < side; ++row) {
        for (std::size_t column = 1; column + 1 < side; ++column) {
            const float* const h = &field.heights[row * side + column];
            const std::array neighbours{*(h - side - 1), *(h - side), *(h - side + 1), *(h - 1), h[1],
                                        h[side - 1],     h[side],     h[side + 1]};
            const auto [least, greatest] = std::ranges::minmax(neighbours);
            const double above = static_cast<double>(*h) - static_cast<double>(greatest);
            const double below = static_cast<double>(least) - static_cast<double>(*h);
            if (std::max(above, below) > threshold) ++count;
        }
    }
    return count;
}

std::uint64_t smooth_field(WaveField& field, double threshold) {
    std::uint64_t count = 0;
    std::vector<float> smoothed = field.heights;
    for_each_odd_cell(field, threshold, [&](std::size_t at, double mean) {
        smoothed[at] = static_cast<float>(mean);
        ++count;
    });
    field.heights = std::move(smoothed);
    return count;
}

std::vector<std::uint8_t> grey_image(const WaveField& field) {
    std::vector<std::uint8_t> grey(field.heights.size(), 128);
    if (field.heights.empty()) return grey;
    const auto [least, greatest] = std::ranges::minmax(field.heights);
    if (!(greatest > least)) return grey;
    const double scale = 255.0 / (static_cast<double>(greatest) - static_cast<double>(least));
    for (std::size_t row = 0; row < field.size; ++row) {
        for (std::size_t column = 0; column < field.size; ++column) {
            const double h = static_cast<double>(field.heights[(field.size - 1 - row) * field.size + column]);
            grey[row * field.size + column] =
                static_cast<std::uint8_t>((h - static_cast<double>(least)) * scale + 0.5);
        }
    }
    return grey;
}

} // namespace linkdig::database
