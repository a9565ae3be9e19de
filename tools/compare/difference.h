#pragma once
/// Two pictures of one shape against each other, in numbers.

#include "ig/configuration.h"
#include "tools/compare/picture.h"
#include "tools/compare/tolerance.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace linkdig::compare {

/// Place of the largest difference of levels beyond 255 in a histogram.
inline constexpr std::size_t beyond_levels = 256;

/// What is looked at, and how.
struct Measure {
    std::span<const std::uint8_t> counted{}; ///< a byte per pixel, 0: ignored. Empty: all count
    std::span<const std::uint8_t> drawn{};   ///< a byte per pixel, 0: background in both. Empty: not known
    Tolerance tolerance{};                   ///< its limits are the buckets
    ig::Scan scan = ig::Scan::horizontal;    ///< which pixel is the first
};

struct Place {
    std::uint32_t column = 0, row = 0;
    std::uint32_t channel = 0;
    bool operator==(const Place&) const = default;
};

/// Levels: 255 is full intensity, at every depth. A sample that is no number against one differs without
/// bound, as do numbers that name things.
struct Difference {
    std::uint64_t counted = 0;   ///< pixels looked at
    std::uint64_t drawn = 0;     ///< of these, not background in both
    std::uint64_t differing = 0; ///< of these, unlike in any channel
    std::uint64_t ignored = 0;   ///< unlike pixels that do not count
    double largest = 0.0;        ///< of a sample
    double mean = 0.0;           ///< over all samples of the counted pixels
    double rms = 0.0;
    double psnr_db = 0.0; ///< 20 log10(255 / rms); 0 if there is no bound
    Place first;          ///< in the order of the scan: by line, then element
    Place worst;          ///< the first that differs by `largest`
    /// Pixels by their largest difference of a channel, rounded up to whole levels; [256] beyond.
    std::array<std::uint64_t, beyond_levels + 1> histogram{};
    std::vector<std::uint64_t> buckets; ///< of the tolerance, and one more for what is beyond its last
};

/// The shapes must be the same (same_shape()).
Difference measure(const Picture& expected, const Picture& actual, const Measure& how);

/// Of drawn pixels.
inline double percent(const Difference& d) {
    return d.drawn == 0 ? 0.0 : 100.0 * static_cast<double>(d.differing) / static_cast<double>(d.drawn);
}

/// Per pixel, the largest difference of a channel in levels; 0 where the pixel does not count.
std::vector<float> difference_levels(const Picture& expected, const Picture& actual, const Measure& how);

} // namespace linkdig::compare
