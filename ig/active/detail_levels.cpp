#include "ig/active/detail_levels.h"

#include "database/model/mathematics.h"
#include "ig/active/shedding.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace linkdig::ig {

namespace {

/// Infinite if no channel is on.
double nearest_eye_m(const FramePacket& packet, const Vec3d& point) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const ChannelView& channel : packet.channels)
        if (channel.on) nearest = std::min(nearest, glm::length(channel.eye_m - point));
    return nearest;
}

double end_m(const VisualDatabase& database, const Detail& detail, std::uint32_t level) {
    return static_cast<double>(database.detail_levels[detail.first_level + level].to_m);
}

/// What is left of 256 between two ranges, falling.
std::uint16_t falling(double range_m, double from_m, double to_m) {
    if (range_m <= from_m) return whole_level;
    if (range_m >= to_m) return 0;
    return static_cast<std::uint16_t>(whole_level * ((to_m - range_m) / (to_m - from_m)) + 0.5);
}

std::uint16_t opacity_of(const VisualDatabase& database, const Detail& detail, double range_m,
                         std::uint32_t held, std::uint32_t k) {
    if (detail.blend_m > 0.0F) return blended_opacity(database, detail, range_m, k);
    const bool present = detail.added != 0 ? k >= held : k == held;
    return present ? whole_level : std::uint16_t{0};
}

} // namespace

std::uint32_t level_at(const VisualDatabase& database, const Detail& detail, double range_m,
                       std::uint32_t held) {
    const bool holds = held <= detail.levels;
    const double half = 0.5 * static_cast<double>(detail.hysteresis_m);
    std::uint32_t level = 0;
    for (; level < detail.levels; ++level) {
        // An end beyond the held level has to be passed by half the hysteresis, one before it to be come back over.
        const double margin = !holds ? 0.0 : level >= held ? half : -half;
        if (range_m <= end_m(database, detail, level) + margin) break;
    }
    return level;
}

std::uint16_t blended_opacity(const VisualDatabase& database, const Detail& detail, double range_m,
                              std::uint32_t k) {
    const double half = 0.5 * static_cast<double>(detail.blend_m);
    const double end = end_m(database, detail, k);
    const std::uint16_t leaving = falling(range_m, end, end + half);
    if (k == 0 || detail.added != 0) return leaving;
    const double begin = end_m(database, detail, k - 1);
    const auto coming = static_cast<std::uint16_t>(whole_level - falling(range_m, begin - half, begin));
    return std::min(leaving, coming);
}

double biased_range_m(double range_m, double bias) {
    constexpr double logarithm_of_2 = 0.69314718055994530942;
    return bias == 0.0 ? range_m : range_m * exponential(-bias * logarithm_of_2);
}

void level_opacities(const VisualDatabase& database, const Detail& detail, double range_m, std::uint32_t held,
                     std::span<std::uint16_t> opacities) {
    for (std::uint32_t k = 0; k < detail.levels; ++k)
        opacities[k] = opacity_of(database, detail, range_m, held, k);
}

void choose_levels(const VisualDatabase& database, const FramePacket& packet, History& history,
                   ActiveDatabase& active) {
    active.level_opacity.assign(database.detail_levels.size(), 0);
    active.detail_range_m.assign(database.details.size(), 0.0);
    if (packet.discontinuity) { // all is forgotten but the memory
        history.held_level.clear();
        history.load = {};
    }
    if (history.held_level.size() != database.details.size())
        history.held_level.assign(database.details.size(), ~0U);
    const double bias = static_cast<double>(packet.lod_bias) + bias_at_step(history.load.step);
    for (std::size_t d = 0; d < database.details.size(); ++d) {
        const Detail& detail = database.details[d];
        const ClusterPose& pose = active.poses[detail.cluster];
        const Vec3d reference = pose.body_origin_m + pose.world_from_body * detail.reference_m;
        active.detail_range_m[d] = nearest_eye_m(packet, reference);
        const double range_m = biased_range_m(active.detail_range_m[d], bias);
        std::uint32_t& held = history.held_level[d];
        if (std::isfinite(range_m)) held = level_at(database, detail, range_m, held);
        level_opacities(database, detail, range_m, held,
                        std::span(active.level_opacity).subspan(detail.first_level, detail.levels));
    }
}

} // namespace linkdig::ig
