#include "tools/compare/histogram.h"

#include <fmt/format.h>

namespace linkdig::compare {

std::vector<HistogramBar> bars_of(const std::array<std::uint64_t, beyond_levels + 1>& histogram) {
    std::vector<HistogramBar> bars;
    std::size_t first = 1;
    for (std::size_t last = 1; first < beyond_levels; last *= 2) {
        const std::size_t end = last < beyond_levels ? last : beyond_levels - 1;
        HistogramBar bar{first == end ? fmt::format("{}", first) : fmt::format("{} to {}", first, end), 0};
        for (std::size_t level = first; level <= end; ++level)
            bar.pixels += histogram[level];
        bars.push_back(std::move(bar));
        first = end + 1;
    }
    bars.push_back({"beyond", histogram[beyond_levels]});
    return bars;
}

} // namespace linkdig::compare
