#include "ig/simd/simd_level.h"

#include <hwy/highway.h>

#include <cstdint>

namespace linkdig::ig {

namespace {

bool plain = false; ///< no SIMD at all; set before threads start, read by them

} // namespace

std::vector<std::string> simd_levels() {
    std::vector<std::string> levels;
    hwy::SetSupportedTargetsForTest(0);
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets())
        levels.emplace_back(hwy::TargetName(target));
    levels.emplace_back("scalar");
    return levels;
}

std::vector<std::string> missing_simd_levels() {
    std::vector<std::string> levels;
    hwy::SetSupportedTargetsForTest(0);
    const std::int64_t missing = HWY_TARGETS & ~static_cast<std::int64_t>(hwy::SupportedTargets());
    for (std::int64_t target = 1; target > 0 && target <= missing; target <<= 1U)
        if ((missing & target) != 0) levels.emplace_back(hwy::TargetName(target));
    return levels;
}

bool simd_is_off() { return plain; }

bool use_simd_level(const std::string& level) {
    if (level == "scalar") {
        plain = true;
        return true;
    }
    hwy::SetSupportedTargetsForTest(0);
    const bool best = level.empty() || level == "best";
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
        if (!best && level != hwy::TargetName(target)) continue;
        if (!best) hwy::SetSupportedTargetsForTest(target);
        hwy::GetChosenTarget().Update(best ? hwy::SupportedTargets() : target);
        plain = false;
        return true;
    }
    return false;
}

} // namespace linkdig::ig
