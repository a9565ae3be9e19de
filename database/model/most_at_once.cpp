#include "database/model/most_at_once.h"

#include <algorithm>

namespace linkdig {

std::map<std::int32_t, std::uint64_t> MostAtOnce::by_level() const {
    std::map<std::pair<std::int32_t, std::int32_t>, std::uint64_t> of_slot;
    for (const auto& [key, count] : counts_) {
        std::uint64_t& most = of_slot[{std::get<0>(key), std::get<1>(key)}];
        most = std::max(most, count);
    }
    std::map<std::int32_t, std::uint64_t> levels;
    for (const auto& [key, count] : of_slot)
        levels[key.first] += count;
    return levels;
}

std::uint64_t MostAtOnce::most(const VisualDatabase& database) const {
    const std::map<std::int32_t, std::uint64_t> levels = by_level();
    const auto count_of = [&](std::uint32_t level) {
        const auto found = levels.find(static_cast<std::int32_t>(level));
        return found == levels.end() ? std::uint64_t{0} : found->second;
    };
    const auto always = levels.find(none);
    std::uint64_t total = always == levels.end() ? 0 : always->second;
    for (const Detail& detail : database.details) {
        std::uint64_t most = 0;
        std::uint64_t all = 0;
        for (std::uint32_t k = detail.first_level; k < detail.first_level + detail.levels; ++k) {
            const bool two = detail.blend_m > 0.0F && k > detail.first_level;
            most = std::max(most, count_of(k) + (two ? count_of(k - 1) : 0));
            all += count_of(k);
        }
        total += detail.added != 0 ? all : most;
    }
    return total;
}

} // namespace linkdig
