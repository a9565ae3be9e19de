// Levels of detail: each detail owns its levels, and every level can be reached.

#include "database/format/validate.h"
#include "database/format/validate_parts.h"

#include <algorithm>

namespace linkdig::database {

namespace {

std::string check_levels(const VisualDatabase& database, std::size_t i) {
    const Detail& detail = database.details[i];
    const double apart = std::max(detail.hysteresis_m, detail.blend_m);
    double inner = -0.5 * apart; // the first level begins at the eye
    for (std::uint32_t k = 0; k < detail.levels; ++k) {
        const std::size_t index = std::size_t{detail.first_level} + k;
        const DetailLevel& level = database.detail_levels[index];
        if (level.detail != i)
            return wrong("detail_levels", index,
                         fmt::format("detail is {}; expected its owner, {}", level.detail, i));
        const double to = static_cast<double>(level.to_m);
        if (!within(to, 0.0, max_coordinate_m) || to <= inner)
            return wrong("detail_levels", index, "to_m leaves no range to the level");
        if (to < inner + apart)
            return wrong("detail_levels", index,
                         "to_m is closer to the level before than blend or hysteresis reach");
        inner = to;
    }
    return {};
}

} // namespace

std::string check_details(const VisualDatabase& database) {
    std::uint64_t next = 0;
    for (std::size_t i = 0; i < database.details.size(); ++i) {
        const Detail& detail = database.details[i];
        if (detail.cluster >= database.clusters.size())
            return out_of_range("details", i, "cluster", detail.cluster, database.clusters.size(),
                                "clusters");
        if (!all_within(detail.reference_m, -max_coordinate_m, max_coordinate_m))
            return wrong("details", i, "reference_m is not finite, or beyond 1e7 m");
        if (!within(detail.hysteresis_m, 0.0, max_coordinate_m) ||
            !within(detail.blend_m, 0.0, max_coordinate_m))
            return wrong("details", i, "hysteresis_m or blend_m is negative, not finite, or beyond 1e7 m");
        if (detail.hysteresis_m > 0.0F && detail.blend_m > 0.0F)
            return wrong("details", i, "hysteresis_m and blend_m are both set");
        if (detail.added > 1) return wrong("details", i, "added is neither 0 nor 1");
        if (detail.levels < 1 || detail.levels > max_detail_levels)
            return wrong("details", i,
                         fmt::format("levels is {}; expected 1 to {}", detail.levels, max_detail_levels));
        if (detail.first_level != next || !span_fits(next, detail.levels, database.detail_levels.size()))
            return wrong("details", i,
                         "first_level is not where the levels before it end, or its levels pass the end");
        next += detail.levels;
        if (std::string reason = check_levels(database, i); !reason.empty()) return reason;
    }
    if (next != database.detail_levels.size())
        return fmt::format("there are {} detail_levels, but details own {}", database.detail_levels.size(),
                           next);
    return {};
}

} // namespace linkdig::database
