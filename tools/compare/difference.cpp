#include "tools/compare/difference.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>
#include <limits>

namespace linkdig::compare {
namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

double distance(double a, double b, bool names) {
    if (a == b || (std::isnan(a) && std::isnan(b))) return 0.0;
    if (names || !std::isfinite(a) || !std::isfinite(b)) return unbounded;
    return std::fabs(a - b);
}

/// Two rows at a time, as levels.
class Rows {
public:
    Rows(const Picture& a, const Picture& b)
        : a_(a), b_(b), levels_a_(std::size_t{a.width} * a.channels), levels_b_(levels_a_.size()),
          comparable_(a.sample == b.sample) {}
    /// False if the row is the same byte for byte: most rows of most frames.
    bool read(std::uint32_t row) {
        if (comparable_ && std::memcmp(a_.bytes.data() + row * a_.row_bytes(),
                                       b_.bytes.data() + row * b_.row_bytes(), a_.row_bytes()) == 0)
            return false;
        row_levels(a_, row, levels_a_.data());
        row_levels(b_, row, levels_b_.data());
        return true;
    }
    const double* a(std::size_t pixel) const { return &levels_a_[pixel * a_.channels]; }
    const double* b(std::size_t pixel) const { return &levels_b_[pixel * a_.channels]; }

private:
    const Picture& a_;
    const Picture& b_;
    std::vector<double> levels_a_, levels_b_;
    bool comparable_;
};

struct PixelDistance {
    double largest = 0.0;
    std::uint32_t channel = 0; ///< the first that differs
    std::uint32_t worst = 0;   ///< the first that differs by `largest`
};

class Meter {
public:
    Meter(const Picture& expected, const Picture& actual, const Measure& how)
        : expected_(expected), how_(how), rows_(expected, actual), names_(expected.names_things()) {
        result_.buckets.assign(how.tolerance.size() + 1, 0);
    }

    Difference run() {
        for (std::uint32_t row = 0; row < expected_.height; ++row) {
            const bool unlike = rows_.read(row);
            for (std::uint32_t column = 0; unlike && column < expected_.width; ++column)
                pixel(column, row);
        }
        count_pixels();
        finish();
        return std::move(result_);
    }

private:
    void pixel(std::uint32_t column, std::uint32_t row) {
        PixelDistance d;
        double sum = 0.0;
        double squares = 0.0;
        for (std::uint32_t k = expected_.channels; k-- > 0;) {
            const double difference = distance(rows_.a(column)[k], rows_.b(column)[k], names_);
            if (difference == 0.0) continue;
            sum += difference;
            squares += difference * difference;
            d.channel = k;
            if (difference < d.largest) continue;
            d.largest = difference;
            d.worst = k;
        }
        if (d.largest == 0.0) return;
        if (!how_.counted.empty() && how_.counted[std::size_t{row} * expected_.width + column] == 0) {
            ++result_.ignored;
            return;
        }
        sum_ += sum;
        squares_ += squares;
        note(d, column, row);
    }

    void note(const PixelDistance& d, std::uint32_t column, std::uint32_t row) {
        if (result_.differing++ == 0 || is_before(column, row, result_.first))
            result_.first = {column, row, d.channel};
        if (d.largest > result_.largest ||
            (d.largest == result_.largest && is_before(column, row, result_.worst))) {
            result_.largest = d.largest;
            result_.worst = {column, row, d.worst};
        }
        const double whole = std::min(std::ceil(d.largest), static_cast<double>(beyond_levels));
        ++result_.histogram[static_cast<std::size_t>(whole)];
        const auto bucket =
            std::ranges::find_if(how_.tolerance, [&](const Bucket& b) { return d.largest <= b.limit; });
        ++result_.buckets[static_cast<std::size_t>(bucket - how_.tolerance.begin())];
    }

    bool is_before(std::uint32_t column, std::uint32_t row, const Place& other) const {
        return how_.scan == ig::Scan::horizontal
                   ? std::pair(row, column) < std::pair(other.row, other.column)
                   : std::pair(column, row) < std::pair(other.column, other.row);
    }

    void count_pixels() {
        const std::size_t pixels = expected_.pixels();
        result_.counted = how_.counted.empty()
                              ? pixels
                              : static_cast<std::uint64_t>(pixels - std::ranges::count(how_.counted, 0));
        result_.drawn = result_.counted;
        if (how_.drawn.empty()) return;
        result_.drawn = 0;
        for (std::size_t k = 0; k < pixels; ++k)
            result_.drawn += how_.drawn[k] != 0 && (how_.counted.empty() || how_.counted[k] != 0) ? 1 : 0;
    }

    void finish() {
        const double samples = static_cast<double>(result_.counted) * expected_.channels;
        if (samples == 0.0) return;
        result_.mean = sum_ / samples;
        result_.rms = std::sqrt(squares_ / samples);
        result_.psnr_db =
            result_.rms > 0.0 && std::isfinite(result_.rms) ? 20.0 * std::log10(255.0 / result_.rms) : 0.0;
        result_.histogram[0] = result_.counted - result_.differing;
    }

    const Picture& expected_;
    const Measure& how_;
    Rows rows_;
    bool names_;
    double sum_ = 0.0;
    double squares_ = 0.0;
    Difference result_;
};

} // namespace

Difference measure(const Picture& expected, const Picture& actual, const Measure& how) {
    assert(same_shape(expected, actual));
    return Meter(expected, actual, how).run();
}

std::vector<float> difference_levels(const Picture& expected, const Picture& actual, const Measure& how) {
    std::vector<float> levels(expected.pixels(), 0.0F);
    Rows rows(expected, actual);
    for (std::uint32_t row = 0; row < expected.height; ++row) {
        if (!rows.read(row)) continue;
        for (std::uint32_t column = 0; column < expected.width; ++column) {
            const std::size_t at = std::size_t{row} * expected.width + column;
            if (!how.counted.empty() && how.counted[at] == 0) continue;
            double largest = 0.0;
            for (std::uint32_t k = 0; k < expected.channels; ++k)
                largest = std::max(largest,
                                   distance(rows.a(column)[k], rows.b(column)[k], expected.names_things()));
            levels[at] = static_cast<float>(largest);
        }
    }
    return levels;
}

} // namespace linkdig::compare
