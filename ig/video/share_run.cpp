#include "ig/video/share_run.h"

#include "ig/edges/edges.h"
#include "ig/simd/simd_level.h"

#include <algorithm>
#include <bit>

#ifndef LINKDIG_SHARE_RUN_ONCE // this file is compiled once per SIMD level
#define LINKDIG_SHARE_RUN_ONCE
namespace linkdig::ig {
namespace {

/// Runs of one face.
struct Runs {
    const RunColour& colour;
    const ShareRun* first;
    std::size_t count;
    const std::uint32_t* weights;
};

} // namespace
} // namespace linkdig::ig
#endif

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

/// A plane along a run: its values clamped, with 15 bits.
struct Along {
    HWY_INLINE explicit Along(const IntensityPlane& plane)
        : plane_(plane), least(hn::Set(SumI(), plane.least)), greatest(hn::Set(SumI(), plane.greatest)),
          one(hn::Set(SumI(), 32767)),
          ramp(hn::Mul(hn::Iota(SumI(), 0), hn::Set(SumI(), static_cast<std::int32_t>(plane.along)))),
          step(hn::Set(SumI(), static_cast<std::int32_t>(plane.along *
                                                         static_cast<std::uint32_t>(hn::Lanes(SumI()))))),
          at(ramp) {}
    HWY_INLINE void Begin(std::int32_t line, std::int32_t element) {
        at = hn::Add(hn::Set(SumI(), static_cast<std::int32_t>(value_at(plane_, line, element))), ramp);
    }
    HWY_INLINE hn::Vec<SumI> Next() {
        const auto clamped = hn::Max(least, hn::Min(at, greatest));
        at = hn::Add(at, step);
        return hn::Min(hn::ShiftRight<7>(clamped), one);
    }
    const IntensityPlane& plane_;
    hn::Vec<SumI> least, greatest, one, ramp, step, at;
};

/// A component of lit(), and of through_air() where there is air.
struct Lighter {
    HWY_INLINE Lighter(std::uint8_t code, std::uint8_t horizon)
        : code_(hn::Set(SumU(), static_cast<std::uint32_t>(code) << 7U)),
          air_(hn::Set(SumI(), std::int32_t{horizon} << 7)) {}
    HWY_INLINE hn::Vec<SumU> Lit(hn::Vec<SumU> scale) const {
        return hn::ShiftRight<15>(hn::Add(hn::Mul(code_, scale), hn::Set(SumU(), 1U << 14U)));
    }
    HWY_INLINE hn::Vec<SumU> ThroughAir(hn::Vec<SumU> shown, hn::Vec<SumI> t) const {
        const auto left = hn::Mul(hn::Sub(hn::BitCast(SumI(), shown), air_), t);
        const auto rounded = hn::ShiftRight<15>(hn::Add(left, hn::Set(SumI(), 1 << 14)));
        return hn::BitCast(SumU(), hn::Add(rounded, air_));
    }
    hn::Vec<SumU> code_;
    hn::Vec<SumI> air_;
};

/// What a vector of one component, and of weights, adds.
HWY_INLINE void AddShare(std::uint32_t* HWY_RESTRICT sums, hn::Vec<SumU> component, hn::Vec<SumU> weight) {
    const SumU d;
    hn::StoreU(hn::Add(hn::LoadU(d, sums), hn::Mul(component, weight)), d, sums);
}

HWY_INLINE void AddLit(std::uint32_t* HWY_RESTRICT sums, const std::uint32_t* HWY_RESTRICT light,
                       hn::Vec<SumU> component, hn::Vec<SumU> weight) {
    const SumU d;
    const auto both = hn::Add(component, hn::LoadU(d, light));
    AddShare(sums, hn::Min(both, hn::Set(d, brightest)), weight);
}

HWY_INLINE void AddLight(std::uint32_t* HWY_RESTRICT light, hn::Vec<SumU> component, hn::Vec<SumU> weight) {
    const SumU d;
    const auto part = hn::ShiftRight<whole_pixel_bits>(hn::Mul(component, weight));
    hn::StoreU(hn::Add(hn::LoadU(d, light), part), d, light);
}

/// The runs a vector at a time: add(place, red, green, blue, weight).
template <bool in_air, typename Add>
HWY_INLINE void ForRunsIn(const Runs& runs, const BandSums& sums, Add add) {
    const SumU du;
    const std::size_t lanes = hn::Lanes(du);
    const RunColour& colour = runs.colour;
    Along intensities(colour.plane);
    Along transmissions(colour.transmission);
    const Lighter red(colour.colour.red, colour.horizon.red);
    const Lighter green(colour.colour.green, colour.horizon.green);
    const Lighter blue(colour.colour.blue, colour.horizon.blue);
    for (const ShareRun *run = runs.first, *end = run + runs.count; run != end; ++run) {
        intensities.Begin(run->line, run->first);
        if (in_air) transmissions.Begin(run->line, run->first);
        const std::size_t place = sums.at(run->line, run->first);
        for (std::size_t k = 0; k < run->count; k += lanes) {
            const auto scale = hn::BitCast(du, intensities.Next());
            auto r = red.Lit(scale), g = green.Lit(scale), b = blue.Lit(scale);
            if (in_air) {
                const auto t = transmissions.Next();
                r = red.ThroughAir(r, t);
                g = green.ThroughAir(g, t);
                b = blue.ThroughAir(b, t);
            }
            // Behind the run's end weights are nought: the sums there stay as they are.
            const auto mine = hn::FirstN(du, std::min<std::size_t>(lanes, run->count - k));
            const auto weight = hn::IfThenElseZero(mine, hn::LoadU(du, runs.weights + run->first_weight + k));
            add(place + k, r, g, b, weight);
        }
    }
}

template <typename Add>
HWY_INLINE void ForRuns(const Runs& runs, const BandSums& sums, Add add) {
    if (runs.colour.in_air) {
        ForRunsIn<true>(runs, sums, add);
    } else {
        ForRunsIn<false>(runs, sums, add);
    }
}

using SumVector = hn::Vec<SumU>;

void AddShareRuns(const Runs& runs, const BandSums& sums) {
    ForRuns(runs, sums,
            [&](std::size_t at, SumVector red, SumVector green, SumVector blue, SumVector weight) HWY_ATTR {
                AddShare(sums.red + at, red, weight);
                AddShare(sums.green + at, green, weight);
                AddShare(sums.blue + at, blue, weight);
            });
}

void AddLitRuns(const Runs& runs, const BandSums& light, const BandSums& sums) {
    ForRuns(runs, sums,
            [&](std::size_t at, SumVector red, SumVector green, SumVector blue, SumVector weight) HWY_ATTR {
                AddLit(sums.red + at, light.red + at, red, weight);
                AddLit(sums.green + at, light.green + at, green, weight);
                AddLit(sums.blue + at, light.blue + at, blue, weight);
            });
}

void AddLightRuns(const Runs& runs, const BandSums& light) {
    ForRuns(runs, light,
            [&](std::size_t at, SumVector red, SumVector green, SumVector blue, SumVector weight) HWY_ATTR {
                AddLight(light.red + at, red, weight);
                AddLight(light.green + at, green, weight);
                AddLight(light.blue + at, blue, weight);
            });
}

/// The level of each sum; the sums of the mask become nought.
HWY_INLINE hn::Vec<SumU> TakeLevels(std::uint32_t* HWY_RESTRICT sums, hn::Mask<SumU> mask) {
    const SumU d;
    const auto sum = hn::LoadU(d, sums);
    hn::StoreU(hn::IfThenZeroElse(mask, sum), d, sums);
    return hn::ShiftRight<24>(hn::Add(sum, hn::Set(d, whole_pixel << 6U)));
}

void WriteShares(const BandSums& sums, std::size_t place, std::uint64_t shared,
                 std::uint32_t* HWY_RESTRICT pixels) {
    const SumU d;
    const auto lanes = static_cast<std::uint32_t>(hn::Lanes(d));
    for (std::uint32_t k = 0; shared != 0; k += lanes, shared >>= lanes) {
        const std::uint8_t bits[8] = {static_cast<std::uint8_t>(shared & 0xffU),
                                      static_cast<std::uint8_t>(shared >> 8U & 0xffU)};
        const auto mask = hn::LoadMaskBits(d, bits);
        const auto red = TakeLevels(sums.red + place + k, mask);
        const auto green = TakeLevels(sums.green + place + k, mask);
        const auto blue = TakeLevels(sums.blue + place + k, mask);
        const auto packed = hn::Or(hn::Or(red, hn::ShiftLeft<8>(green)),
                                   hn::Or(hn::ShiftLeft<16>(blue), hn::Set(d, 0xff000000U)));
        hn::BlendedStore(packed, mask, d, pixels + k);
    }
}

} // namespace HWY_NAMESPACE
} // namespace linkdig::ig
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace linkdig::ig {

namespace {

HWY_EXPORT(AddShareRuns);
HWY_EXPORT(AddLitRuns);
HWY_EXPORT(AddLightRuns);
HWY_EXPORT(WriteShares);

/// The runs pixel by pixel: add(place, components, weight).
template <typename Add>
void for_runs(const Runs& runs, const BandSums& sums, Add add) {
    const RunColour& colour = runs.colour;
    for (const ShareRun* run = runs.first; run != runs.first + runs.count; ++run) {
        std::uint32_t value = value_at(colour.plane, run->line, run->first);
        const std::size_t place = sums.at(run->line, run->first);
        for (std::uint32_t k = 0; k < run->count; ++k, value += colour.plane.along) {
            const auto intensity =
                std::clamp(static_cast<std::int32_t>(value), colour.plane.least, colour.plane.greatest);
            Components seen = lit(colour.colour, intensity);
            if (colour.in_air) {
                const auto element = static_cast<std::int32_t>(run->first + k);
                const std::int32_t t = planar_transmission(colour.transmission, run->line, element);
                seen = through_air(seen, t, colour.horizon);
            }
            add(place + k, seen, runs.weights[run->first_weight + k]);
        }
    }
}

void write_plainly(const BandSums& sums, std::size_t place, std::uint64_t shared, std::uint32_t* pixels) {
    constexpr std::uint32_t half = whole_pixel << 6U;
    for (; shared != 0; shared &= shared - 1) {
        const auto k = static_cast<std::size_t>(std::countr_zero(shared));
        std::uint32_t &red = sums.red[place + k], &green = sums.green[place + k],
                      &blue = sums.blue[place + k];
        pixels[k] = ((red + half) >> 24U) | ((green + half) >> 24U) << 8U | ((blue + half) >> 24U) << 16U |
                    0xff000000U;
        red = green = blue = 0;
    }
}

} // namespace

void add_share_runs(const RunColour& colour, std::span<const ShareRun> runs, const std::uint32_t* weights,
                    const BandSums& sums) {
    const Runs all{colour, runs.data(), runs.size(), weights};
    if (!simd_is_off()) {
        HWY_DYNAMIC_DISPATCH(AddShareRuns)(all, sums);
        return;
    }
    for_runs(all, sums, [&](std::size_t at, const Components& seen, std::uint32_t weight) {
        sums.red[at] += seen.red * weight;
        sums.green[at] += seen.green * weight;
        sums.blue[at] += seen.blue * weight;
    });
}

void add_lit_runs(const RunColour& colour, std::span<const ShareRun> runs, const std::uint32_t* weights,
                  const BandSums& light, const BandSums& sums) {
    const Runs all{colour, runs.data(), runs.size(), weights};
    if (!simd_is_off()) {
        HWY_DYNAMIC_DISPATCH(AddLitRuns)(all, light, sums);
        return;
    }
    for_runs(all, sums, [&](std::size_t at, const Components& seen, std::uint32_t weight) {
        sums.red[at] += std::min(seen.red + light.red[at], brightest) * weight;
        sums.green[at] += std::min(seen.green + light.green[at], brightest) * weight;
        sums.blue[at] += std::min(seen.blue + light.blue[at], brightest) * weight;
    });
}

void add_light_runs(const RunColour& colour, std::span<const ShareRun> runs, const std::uint32_t* weights,
                    const BandSums& light) {
    const Runs all{colour, runs.data(), runs.size(), weights};
    if (!simd_is_off()) {
        HWY_DYNAMIC_DISPATCH(AddLightRuns)(all, light);
        return;
    }
    for_runs(all, light, [&](std::size_t at, const Components& seen, std::uint32_t weight) {
        light.red[at] += seen.red * weight >> whole_pixel_bits;
        light.green[at] += seen.green * weight >> whole_pixel_bits;
        light.blue[at] += seen.blue * weight >> whole_pixel_bits;
    });
}

void write_shares(const BandSums& sums, std::uint32_t line, std::uint32_t element, std::uint64_t shared,
                  std::uint32_t* pixels) {
    if (simd_is_off()) {
        write_plainly(sums, sums.at(line, element), shared, pixels);
    } else {
        HWY_DYNAMIC_DISPATCH(WriteShares)(sums, sums.at(line, element), shared, pixels);
    }
}

} // namespace linkdig::ig
#endif
