#include "ig/video/pixel_run.h"

#include <algorithm>

#ifndef LINKDIG_INVERSE_RANGE // this file is compiled once per SIMD level
#define LINKDIG_INVERSE_RANGE
namespace linkdig::ig {
/// 1/z over a run: start + (offset + k) * along, and the elements' ray lengths.
struct InverseRange {
    float start = 0;
    float along = 0;
    std::int32_t offset = 0;
    const float* rays = nullptr;
};
} // namespace linkdig::ig
#endif

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "ig/video/pixel_run.cpp"
#include <hwy/foreach_target.h> // compiles this file once for every SIMD level
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace linkdig::ig {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

#if HWY_TARGET != HWY_SCALAR // one lane has no 16-bit halves: the plain loops at the end do it all there

using I32 = hn::ScalableTag<std::int32_t>;
using U32 = hn::Repartition<std::uint32_t, I32>;
using I16 = hn::Repartition<std::int16_t, I32>;
using F32 = hn::Repartition<float, I32>;

/// A 15-bit factor in both 16-bit halves of each lane, so that one fixed-point multiplication, (a b + 2^14) >> 15,
/// makes red and green, and another blue.
HWY_INLINE hn::Vec<I16> BothHalves(hn::Vec<I32> factor) {
    return hn::BitCast(I16(), hn::Or(factor, hn::ShiftLeft<16>(factor)));
}

HWY_INLINE hn::Vec<I16> Pair(int low, int high) {
    return hn::BitCast(I16(), hn::Set(I32(), low | high << 16));
}

/// Intensities of consecutive pixels, clamped to the corners' range, with 15 bits.
struct Intensities {
    HWY_INLINE Intensities(const IntensityPlane& plane, std::uint32_t value)
        : least(hn::Set(I32(), plane.least)), greatest(hn::Set(I32(), plane.greatest)),
          one(hn::Set(I32(), 32767)),
          step(hn::Set(
              I32(), static_cast<std::int32_t>(plane.along * static_cast<std::uint32_t>(hn::Lanes(I32()))))),
          at(hn::Add(hn::Set(I32(), static_cast<std::int32_t>(value)),
                     hn::Mul(hn::Iota(I32(), 0), hn::Set(I32(), static_cast<std::int32_t>(plane.along))))) {}
    HWY_INLINE hn::Vec<I32> Next() {
        const auto clamped = hn::Max(least, hn::Min(at, greatest));
        at = hn::Add(at, step);
        return hn::Min(hn::ShiftRight<7>(clamped), one);
    }
    hn::Vec<I32> least, greatest, one, step, at;
};

HWY_INLINE void StorePixels(hn::Vec<I16> red_green, hn::Vec<I16> blue, std::uint32_t* HWY_RESTRICT pixels) {
    const U32 d;
    const auto rg = hn::BitCast(d, red_green);
    const auto b = hn::BitCast(d, blue);
    const auto rg_packed = hn::And(hn::Or(rg, hn::ShiftRight<8>(rg)), hn::Set(d, 0xffffU));
    hn::StoreU(hn::Or(hn::Or(rg_packed, hn::ShiftLeft<16>(b)), hn::Set(d, 0xff000000U)), d, pixels);
}

/// As shade_through_air() for each lane.
struct AirMixer {
    HWY_INLINE AirMixer(Colour colour, Colour horizon)
        : rg(Pair(colour.red << 7, colour.green << 7)), b(Pair(colour.blue << 7, 0)),
          horizon_rg(Pair(horizon.red << 7, horizon.green << 7)), horizon_b(Pair(horizon.blue << 7, 0)) {}
    HWY_INLINE hn::Vec<I16> Mix(hn::Vec<I16> face, hn::Vec<I16> air, hn::Vec<I16> i, hn::Vec<I16> t,
                                hn::Vec<I16> rest) const {
        const auto seen = hn::MulFixedPoint15(hn::MulFixedPoint15(face, i), t);
        const auto sum = hn::Add(hn::Add(seen, hn::MulFixedPoint15(air, rest)), hn::Set(I16(), 64));
        return hn::ShiftRight<7>(sum);
    }
    HWY_INLINE void Store(hn::Vec<I32> intensity, hn::Vec<I32> transmission, std::uint32_t* pixels) const {
        const auto i = BothHalves(intensity);
        const auto t = BothHalves(transmission);
        const auto rest = BothHalves(hn::Sub(hn::Set(I32(), transmission_one), transmission));
        StorePixels(Mix(rg, horizon_rg, i, t, rest), Mix(b, horizon_b, i, t, rest), pixels);
    }
    hn::Vec<I16> rg, b, horizon_rg, horizon_b;
};

#endif

std::size_t ShadeRun(const IntensityPlane& plane, Colour colour, std::uint32_t value, std::size_t count,
                     std::uint32_t* HWY_RESTRICT pixels) {
    std::size_t k = 0;
#if HWY_TARGET != HWY_SCALAR
    const std::size_t lanes = hn::Lanes(I32());
    const auto red_green = Pair(colour.red, colour.green);
    const auto blue = Pair(colour.blue, 0);
    Intensities intensities(plane, value);
    for (; k + lanes <= count; k += lanes) {
        const auto i = BothHalves(intensities.Next());
        StorePixels(hn::MulFixedPoint15(i, red_green), hn::MulFixedPoint15(i, blue), pixels + k);
    }
#else
    (void)plane, (void)colour, (void)value, (void)count, (void)pixels;
#endif
    return k;
}

std::size_t ShadeRunInHaze(const IntensityPlane& plane, Colour colour, std::uint32_t value,
                           std::int32_t transmission, Colour horizon, std::size_t count,
                           std::uint32_t* HWY_RESTRICT pixels) {
    std::size_t k = 0;
#if HWY_TARGET != HWY_SCALAR
    const std::size_t lanes = hn::Lanes(I32());
    const AirMixer mixer(colour, horizon);
    const auto t = hn::Set(I32(), transmission);
    Intensities intensities(plane, value);
    for (; k + lanes <= count; k += lanes)
        mixer.Store(intensities.Next(), t, pixels + k);
#else
    (void)plane, (void)colour, (void)value, (void)transmission, (void)horizon, (void)count, (void)pixels;
#endif
    return k;
}

std::size_t ShadeRunInAir(const IntensityPlane& plane, Colour colour, std::uint32_t value,
                          const InverseRange& range, const Air& air, std::size_t count,
                          std::uint32_t* HWY_RESTRICT pixels) {
    std::size_t k = 0;
#if HWY_TARGET != HWY_SCALAR
    const std::size_t lanes = hn::Lanes(I32());
    const AirMixer mixer(colour, air.horizon());
    Intensities intensities(plane, value);
    const auto start = hn::Set(F32(), range.start);
    const auto along = hn::Set(F32(), range.along);
    const auto least = hn::Set(F32(), least_inverse_m);
    const auto steps = hn::Set(F32(), air.steps_per_m());
    const auto last = hn::Set(F32(), static_cast<float>(transmission_entries - 1));
    const auto half = hn::Set(F32(), 0.5F);
    for (; k + lanes <= count; k += lanes) {
        // The order of operations is transmission_of()'s; Mul and Add stay apart.
        const auto offset =
            hn::ConvertTo(F32(), hn::Iota(I32(), range.offset + static_cast<std::int32_t>(k)));
        const auto inverse = hn::Max(hn::Add(start, hn::Mul(offset, along)), least);
        const auto range_m = hn::Div(hn::LoadU(F32(), range.rays + k), inverse);
        const auto step = hn::Min(hn::Add(hn::Mul(range_m, steps), half), last);
        mixer.Store(intensities.Next(),
                    hn::GatherIndex(I32(), air.transmission(), hn::ConvertTo(I32(), step)), pixels + k);
    }
#else
    (void)plane, (void)colour, (void)value, (void)range, (void)air, (void)count, (void)pixels;
#endif
    return k;
}

} // namespace HWY_NAMESPACE
} // namespace linkdig::ig
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace linkdig::ig {

namespace {

HWY_EXPORT(ShadeRun);
HWY_EXPORT(ShadeRunInHaze);
HWY_EXPORT(ShadeRunInAir);

bool plain = false; ///< no SIMD at all; set before threads start, read by them

/// Elements over which 1/z runs in float.
constexpr std::int32_t block_elements = 64;

std::uint32_t value_at(const IntensityPlane& plane, std::int32_t line, std::int32_t element) {
    return plane.value + static_cast<std::uint32_t>(element - plane.reference_element) * plane.along +
           static_cast<std::uint32_t>(line - plane.reference_line) * plane.across;
}

std::int32_t clamped(const IntensityPlane& plane, std::uint32_t value) {
    const auto i = static_cast<std::int32_t>(value);
    return i < plane.least ? plane.least : i > plane.greatest ? plane.greatest : i;
}

InverseRange inverse_range(const DepthPlane& depth, const Air& air, std::int32_t line, std::int32_t element) {
    const std::int32_t block = element & ~(block_elements - 1);
    InverseRange range;
    range.start = static_cast<float>((depth.inverse_m + line * depth.across) + block * depth.along);
    range.along = static_cast<float>(depth.along);
    range.offset = element - block;
    range.rays = air.rays(static_cast<std::uint32_t>(line)) + element;
    return range;
}

std::int32_t transmission_in(const InverseRange& range, const Air& air, std::int32_t k) {
    const float inverse =
        std::max(range.start + static_cast<float>(range.offset + k) * range.along, least_inverse_m);
    const float range_m = range.rays[k] / inverse;
    const float step =
        std::min(range_m * air.steps_per_m() + 0.5F, static_cast<float>(transmission_entries - 1));
    return air.transmission()[static_cast<std::int32_t>(step)];
}

} // namespace

void shade_run(const IntensityPlane& plane, Colour colour, std::int32_t line, std::int32_t element,
               std::uint32_t count, std::uint32_t* pixels) {
    std::uint32_t value = value_at(plane, line, element);
    std::size_t k = plain ? 0 : HWY_DYNAMIC_DISPATCH(ShadeRun)(plane, colour, value, count, pixels);
    for (value += static_cast<std::uint32_t>(k) * plane.along; k < count; ++k, value += plane.along) {
        pixels[k] = shade(colour, clamped(plane, value));
    }
}

void shade_run_in_haze(const IntensityPlane& plane, Colour colour, std::int32_t transmission, Colour horizon,
                       std::int32_t line, std::int32_t element, std::uint32_t count, std::uint32_t* pixels) {
    std::uint32_t value = value_at(plane, line, element);
    std::size_t k = plain ? 0
                          : HWY_DYNAMIC_DISPATCH(ShadeRunInHaze)(plane, colour, value, transmission, horizon,
                                                                 count, pixels);
    for (value += static_cast<std::uint32_t>(k) * plane.along; k < count; ++k, value += plane.along) {
        pixels[k] = shade_through_air(colour, clamped(plane, value), transmission, horizon);
    }
}

void shade_run_in_air(const IntensityPlane& plane, Colour colour, const DepthPlane& depth, const Air& air,
                      std::int32_t line, std::int32_t element, std::uint32_t count, std::uint32_t* pixels) {
    const std::int32_t end = element + static_cast<std::int32_t>(count);
    while (element < end) {
        const std::int32_t stop = std::min(end, (element & ~(block_elements - 1)) + block_elements);
        const auto length = static_cast<std::size_t>(stop - element);
        const InverseRange range = inverse_range(depth, air, line, element);
        std::uint32_t value = value_at(plane, line, element);
        std::size_t k =
            plain ? 0 : HWY_DYNAMIC_DISPATCH(ShadeRunInAir)(plane, colour, value, range, air, length, pixels);
        for (value += static_cast<std::uint32_t>(k) * plane.along; k < length; ++k, value += plane.along) {
            pixels[k] =
                shade_through_air(colour, clamped(plane, value),
                                  transmission_in(range, air, static_cast<std::int32_t>(k)), air.horizon());
        }
        pixels += length;
        element = stop;
    }
}

std::int32_t transmission_of(const DepthPlane& depth, const Air& air, std::int32_t line,
                             std::int32_t element) {
    return transmission_in(inverse_range(depth, air, line, element), air, 0);
}

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
#endif
