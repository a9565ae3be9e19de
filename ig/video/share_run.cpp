#include "ig/video/share_run.h"

#include "ig/simd/simd_level.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "ig/video/share_run.cpp"
#include <hwy/foreach_target.h> // compiles this file once for every SIMD level
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace linkdig::ig {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using SumI = hn::CappedTag<std::int32_t, 16>; // the paddings have room for 16
using SumU = hn::Repartition<std::uint32_t, SumI>;

/// A component of lit(), and of through_air() where there is air.
struct Lighter {
    HWY_INLINE Lighter(std::uint8_t code, std::uint8_t horizon, std::int32_t transmission)
        : code_(hn::Set(SumU(), static_cast<std::uint32_t>(code) << 7U)), t_(hn::Set(SumI(), transmission)),
          air_(hn::Set(SumI(), std::int32_t{horizon} << 7)), in_air_(transmission >= 0) {}
    HWY_INLINE hn::Vec<SumU> At(hn::Vec<SumU> scale) const {
        const auto shown = hn::ShiftRight<15>(hn::Add(hn::Mul(code_, scale), hn::Set(SumU(), 1U << 14U)));
        if (!in_air_) return shown;
        const auto left = hn::Mul(hn::Sub(hn::BitCast(SumI(), shown), air_), t_);
        const auto rounded = hn::ShiftRight<15>(hn::Add(left, hn::Set(SumI(), 1 << 14)));
        return hn::BitCast(SumU(), hn::Add(rounded, air_));
    }
    hn::Vec<SumU> code_;
    hn::Vec<SumI> t_, air_;
    bool in_air_;
};

HWY_INLINE void AddTo(std::uint32_t* HWY_RESTRICT sums, hn::Vec<SumU> component, hn::Vec<SumU> weight) {
    const SumU d;
    hn::StoreU(hn::Add(hn::LoadU(d, sums), hn::Mul(component, weight)), d, sums);
}

void AddShareRun(const RunColour& run, std::uint32_t value, std::size_t count,
                 const std::uint32_t* HWY_RESTRICT weights, const SumsAt& sums) {
    const SumI di;
    const SumU du;
    const std::size_t lanes = hn::Lanes(di);
    const auto least = hn::Set(di, run.plane.least);
    const auto greatest = hn::Set(di, run.plane.greatest);
    const auto one = hn::Set(di, 32767);
    const auto along = static_cast<std::int32_t>(run.plane.along);
    auto at =
        hn::Add(hn::Set(di, static_cast<std::int32_t>(value)), hn::Mul(hn::Iota(di, 0), hn::Set(di, along)));
    const auto step =
        hn::Set(di, static_cast<std::int32_t>(run.plane.along * static_cast<std::uint32_t>(lanes)));
    const Lighter red(run.colour.red, run.horizon.red, run.transmission);
    const Lighter green(run.colour.green, run.horizon.green, run.transmission);
    const Lighter blue(run.colour.blue, run.horizon.blue, run.transmission);
    for (std::size_t k = 0; k < count; k += lanes) {
        const auto clamped = hn::Max(least, hn::Min(at, greatest));
        at = hn::Add(at, step);
        const auto scale = hn::BitCast(du, hn::Min(hn::ShiftRight<7>(clamped), one));
        // Behind the run's end weights are nought: the sums there stay as they are.
        const auto mine = hn::FirstN(du, std::min(lanes, count - k));
        const auto weight = hn::IfThenElseZero(mine, hn::LoadU(du, weights + k));
        AddTo(sums.red + k, red.At(scale), weight);
        AddTo(sums.green + k, green.At(scale), weight);
        AddTo(sums.blue + k, blue.At(scale), weight);
    }
}

} // namespace HWY_NAMESPACE
} // namespace linkdig::ig
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace linkdig::ig {

namespace {

HWY_EXPORT(AddShareRun);

/// Shorter runs are not worth a vector's setting up.
constexpr std::uint32_t short_run = 3;

} // namespace

void add_share_run(const RunColour& run, std::int32_t line, std::int32_t element, std::uint32_t count,
                   const std::uint32_t* weights, const SumsAt& sums) {
    const IntensityPlane& plane = run.plane;
    std::uint32_t value = plane.value +
                          static_cast<std::uint32_t>(element - plane.reference_element) * plane.along +
                          static_cast<std::uint32_t>(line - plane.reference_line) * plane.across;
    if (count > short_run && !simd_is_off()) {
        HWY_DYNAMIC_DISPATCH(AddShareRun)(run, value, count, weights, sums);
        return;
    }
    for (std::uint32_t k = 0; k < count; ++k, value += plane.along) {
        const auto intensity = std::clamp(static_cast<std::int32_t>(value), plane.least, plane.greatest);
        Components seen = lit(run.colour, intensity);
        if (run.transmission >= 0) seen = through_air(seen, run.transmission, run.horizon);
        sums.red[k] += seen.red * weights[k];
        sums.green[k] += seen.green * weights[k];
        sums.blue[k] += seen.blue * weights[k];
    }
}

} // namespace linkdig::ig
#endif
