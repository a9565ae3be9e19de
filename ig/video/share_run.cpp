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

/// What a vector of one component, and of weights, adds.
struct Adder {
    static HWY_INLINE void Share(std::uint32_t* HWY_RESTRICT sums, hn::Vec<SumU> component,
                                 hn::Vec<SumU> weight) {
        const SumU d;
        hn::StoreU(hn::Add(hn::LoadU(d, sums), hn::Mul(component, weight)), d, sums);
    }
    static HWY_INLINE void Lit(std::uint32_t* HWY_RESTRICT sums, const std::uint32_t* HWY_RESTRICT light,
                               hn::Vec<SumU> component, hn::Vec<SumU> weight) {
        const SumU d;
        const auto both = hn::Add(component, hn::LoadU(d, light));
        Share(sums, hn::Min(both, hn::Set(d, brightest)), weight);
    }
    static HWY_INLINE void Light(std::uint32_t* HWY_RESTRICT light, hn::Vec<SumU> component,
                                 hn::Vec<SumU> weight) {
        const SumU d;
        hn::StoreU(hn::Add(hn::LoadU(d, light), hn::ShiftRight<whole_pixel_bits>(hn::Mul(component, weight))),
                   d, light);
    }
};

/// The run a vector at a time: add(k, red, green, blue, weight).
template <typename Add>
HWY_INLINE void ForRun(const RunColour& run, std::uint32_t value, const RunPlace& place, Add add) {
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
    for (std::size_t k = 0; k < place.count; k += lanes) {
        const auto clamped = hn::Max(least, hn::Min(at, greatest));
        at = hn::Add(at, step);
        const auto scale = hn::BitCast(du, hn::Min(hn::ShiftRight<7>(clamped), one));
        // Behind the run's end weights are nought: the sums there stay as they are.
        const auto mine = hn::FirstN(du, std::min(lanes, place.count - k));
        const auto weight = hn::IfThenElseZero(mine, hn::LoadU(du, place.weights + k));
        add(k, red.At(scale), green.At(scale), blue.At(scale), weight);
    }
}

void AddShareRun(const RunColour& run, std::uint32_t value, const RunPlace& place, const SumsAt& sums) {
    using Vector = hn::Vec<SumU>;
    ForRun(run, value, place,
           [&](std::size_t k, Vector red, Vector green, Vector blue, Vector weight) HWY_ATTR {
               Adder::Share(sums.red + k, red, weight);
               Adder::Share(sums.green + k, green, weight);
               Adder::Share(sums.blue + k, blue, weight);
           });
}

void AddLitRun(const RunColour& run, std::uint32_t value, const RunPlace& place, const SumsAt& light,
               const SumsAt& sums) {
    using Vector = hn::Vec<SumU>;
    ForRun(run, value, place,
           [&](std::size_t k, Vector red, Vector green, Vector blue, Vector weight) HWY_ATTR {
               Adder::Lit(sums.red + k, light.red + k, red, weight);
               Adder::Lit(sums.green + k, light.green + k, green, weight);
               Adder::Lit(sums.blue + k, light.blue + k, blue, weight);
           });
}

void AddLightRun(const RunColour& run, std::uint32_t value, const RunPlace& place, const SumsAt& light) {
    using Vector = hn::Vec<SumU>;
    ForRun(run, value, place,
           [&](std::size_t k, Vector red, Vector green, Vector blue, Vector weight) HWY_ATTR {
               Adder::Light(light.red + k, red, weight);
               Adder::Light(light.green + k, green, weight);
               Adder::Light(light.blue + k, blue, weight);
           });
}

} // namespace HWY_NAMESPACE
} // namespace linkdig::ig
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace linkdig::ig {

namespace {

HWY_EXPORT(AddShareRun);
HWY_EXPORT(AddLitRun);
HWY_EXPORT(AddLightRun);

/// Shorter runs are not worth a vector's setting up.
constexpr std::uint32_t short_run = 3;

bool by_vectors(const RunPlace& place) { return place.count > short_run && !simd_is_off(); }

std::uint32_t first_value(const IntensityPlane& plane, const RunPlace& place) {
    return plane.value + static_cast<std::uint32_t>(place.element - plane.reference_element) * plane.along +
           static_cast<std::uint32_t>(place.line - plane.reference_line) * plane.across;
}

/// The run pixel by pixel: add(k, components, weight).
template <typename Add>
void for_run(const RunColour& run, std::uint32_t value, const RunPlace& place, Add add) {
    for (std::uint32_t k = 0; k < place.count; ++k, value += run.plane.along) {
        const auto intensity =
            std::clamp(static_cast<std::int32_t>(value), run.plane.least, run.plane.greatest);
        Components seen = lit(run.colour, intensity);
        if (run.transmission >= 0) seen = through_air(seen, run.transmission, run.horizon);
        add(k, seen, place.weights[k]);
    }
}

} // namespace

void add_share_run(const RunColour& run, const RunPlace& place, const SumsAt& sums) {
    const std::uint32_t value = first_value(run.plane, place);
    if (by_vectors(place)) {
        HWY_DYNAMIC_DISPATCH(AddShareRun)(run, value, place, sums);
        return;
    }
    for_run(run, value, place, [&](std::uint32_t k, const Components& seen, std::uint32_t weight) {
        sums.red[k] += seen.red * weight;
        sums.green[k] += seen.green * weight;
        sums.blue[k] += seen.blue * weight;
    });
}

void add_lit_run(const RunColour& run, const RunPlace& place, const SumsAt& light, const SumsAt& sums) {
    const std::uint32_t value = first_value(run.plane, place);
    if (by_vectors(place)) {
        HWY_DYNAMIC_DISPATCH(AddLitRun)(run, value, place, light, sums);
        return;
    }
    for_run(run, value, place, [&](std::uint32_t k, const Components& seen, std::uint32_t weight) {
        sums.red[k] += std::min(seen.red + light.red[k], brightest) * weight;
        sums.green[k] += std::min(seen.green + light.green[k], brightest) * weight;
        sums.blue[k] += std::min(seen.blue + light.blue[k], brightest) * weight;
    });
}

void add_light_run(const RunColour& run, const RunPlace& place, const SumsAt& light) {
    const std::uint32_t value = first_value(run.plane, place);
    if (by_vectors(place)) {
        HWY_DYNAMIC_DISPATCH(AddLightRun)(run, value, place, light);
        return;
    }
    for_run(run, value, place, [&](std::uint32_t k, const Components& seen, std::uint32_t weight) {
        light.red[k] += seen.red * weight >> whole_pixel_bits;
        light.green[k] += seen.green * weight >> whole_pixel_bits;
        light.blue[k] += seen.blue * weight >> whole_pixel_bits;
    });
}

} // namespace linkdig::ig
#endif
