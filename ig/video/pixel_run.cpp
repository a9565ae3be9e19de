#include "ig/video/pixel_run.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "ig/video/pixel_run.cpp"
#include <hwy/foreach_target.h> // compiles this file once for every SIMD level
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace linkdig::ig {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// As shade() for each lane. A lane's two 16-bit halves hold the same 15-bit intensity, so that one
/// fixed-point multiplication, (a b + 2^14) >> 15, makes red and green, and another blue.
void ShadeRun(const IntensityPlane& plane, Colour colour, std::uint32_t value, std::uint32_t count,
              std::uint32_t* HWY_RESTRICT pixels) {
    std::size_t k = 0;
#if HWY_TARGET != HWY_SCALAR // one lane has no 16-bit halves: the rest of this function does it all
    const hn::ScalableTag<std::int32_t> d;
    const hn::Repartition<std::uint32_t, decltype(d)> du;
    const hn::Repartition<std::int16_t, decltype(d)> dh;
    const std::size_t lanes = hn::Lanes(d);
    const auto red_green = hn::BitCast(dh, hn::Set(d, colour.red | colour.green << 16));
    const auto blue_only = hn::BitCast(dh, hn::Set(d, colour.blue));
    const auto least = hn::Set(d, plane.least);
    const auto greatest = hn::Set(d, plane.greatest);
    const auto one = hn::Set(d, 32767);
    const auto low_half = hn::Set(du, 0xffffU);
    const auto opaque = hn::Set(du, 0xff000000U);
    const auto step = hn::Set(d, static_cast<std::int32_t>(plane.along * static_cast<std::uint32_t>(lanes)));
    auto at = hn::Add(hn::Set(d, static_cast<std::int32_t>(value)),
                      hn::Mul(hn::Iota(d, 0), hn::Set(d, static_cast<std::int32_t>(plane.along))));
    for (; k + lanes <= count; k += lanes) {
        const auto clamped = hn::Max(least, hn::Min(at, greatest));
        const auto scale = hn::Min(hn::ShiftRight<7>(clamped), one);
        const auto both = hn::BitCast(dh, hn::Or(scale, hn::ShiftLeft<16>(scale)));
        const auto rg = hn::BitCast(du, hn::MulFixedPoint15(both, red_green));
        const auto b = hn::BitCast(du, hn::MulFixedPoint15(both, blue_only));
        const auto rg_packed = hn::And(hn::Or(rg, hn::ShiftRight<8>(rg)), low_half);
        hn::StoreU(hn::Or(hn::Or(rg_packed, hn::ShiftLeft<16>(b)), opaque), du, pixels + k);
        at = hn::Add(at, step);
    }
#endif
    value += static_cast<std::uint32_t>(k) * plane.along;
    for (; k < count; ++k, value += plane.along) {
        const auto i = static_cast<std::int32_t>(value);
        pixels[k] = shade(colour, i < plane.least ? plane.least : i > plane.greatest ? plane.greatest : i);
    }
}

} // namespace HWY_NAMESPACE
} // namespace linkdig::ig
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace linkdig::ig {

namespace {

HWY_EXPORT(ShadeRun);

void shade_run_scalar(const IntensityPlane& plane, Colour colour, std::uint32_t value, std::uint32_t count,
                      std::uint32_t* pixels) {
    for (std::uint32_t k = 0; k < count; ++k, value += plane.along) {
        const auto i = static_cast<std::int32_t>(value);
        pixels[k] = shade(colour, i < plane.least ? plane.least : i > plane.greatest ? plane.greatest : i);
    }
}

using ShadeRunFunction = void (*)(const IntensityPlane&, Colour, std::uint32_t, std::uint32_t,
                                  std::uint32_t*);

void shade_run_simd(const IntensityPlane& plane, Colour colour, std::uint32_t value, std::uint32_t count,
                    std::uint32_t* pixels) {
    HWY_DYNAMIC_DISPATCH(ShadeRun)(plane, colour, value, count, pixels);
}

ShadeRunFunction chosen = shade_run_simd; // set before threads start, read by them

} // namespace

void shade_run(const IntensityPlane& plane, Colour colour, std::int32_t line, std::int32_t element,
               std::uint32_t count, std::uint32_t* pixels) {
    const std::uint32_t value = plane.value +
                                static_cast<std::uint32_t>(element - plane.reference_element) * plane.along +
                                static_cast<std::uint32_t>(line - plane.reference_line) * plane.across;
    chosen(plane, colour, value, count, pixels);
}

std::vector<std::string> simd_levels() {
    std::vector<std::string> levels;
    hwy::SetSupportedTargetsForTest(0);
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets())
        levels.emplace_back(hwy::TargetName(target));
    levels.emplace_back("scalar");
    return levels;
}

bool use_simd_level(const std::string& level) {
    if (level == "scalar") {
        chosen = shade_run_scalar;
        return true;
    }
    hwy::SetSupportedTargetsForTest(0);
    const bool best = level.empty() || level == "best";
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
        if (!best && level != hwy::TargetName(target)) continue;
        if (!best) hwy::SetSupportedTargetsForTest(target);
        hwy::GetChosenTarget().Update(best ? hwy::SupportedTargets() : target);
        chosen = shade_run_simd;
        return true;
    }
    return false;
}

} // namespace linkdig::ig
#endif
