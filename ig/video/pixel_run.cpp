#include "ig/video/pixel_run.h"

#include "ig/edges/edges.h"
#include "ig/prefetch.h"
#include "ig/simd/simd_level.h"
#include "ig/video/air_samples.h"
#include "ig/video/inverse_range.h"

#include <hwy/cache_control.h>

#include <algorithm>

#ifndef LINKDIG_PLAIN_RUNS // this file is compiled once per SIMD level
#define LINKDIG_PLAIN_RUNS
namespace linkdig::ig {
namespace {

/// Each pixel of the runs by what `shaded` says of its line, element and intensity.
template <typename Shaded>
void shade_one_by_one(const IntensityPlane& plane, std::span<const Segment> runs, const BandPixels& pixels,
                      Shaded shaded) {
    for (const Segment& run : runs) {
        std::uint32_t* pixel = pixels.at(run);
        for (std::int32_t element = run.first; element < run.first + run.count; ++element, ++pixel) {
            const auto value = static_cast<std::int32_t>(value_at(plane, run.line, element));
            *pixel = shaded(run.line, element, std::max(plane.least, std::min(value, plane.greatest)));
        }
    }
}

void shade_plainly(const IntensityPlane& plane, Colour colour, std::span<const Segment> runs,
                   const BandPixels& pixels) {
    shade_one_by_one(plane, runs, pixels, [&](std::int32_t, std::int32_t, std::int32_t intensity) {
        return shade(colour, intensity);
    });
}

/// Of all the runs of a face the same.
bool is_level(const IntensityPlane& plane) { return plane.least == plane.greatest; }

/// A band's faces, one after the other, as shade_faces(). `clear` is given a face's runs, its colour code and its plane, `hazy`
/// the plane of the transmission, too.
template <typename Clear, typename Hazy>
[[gnu::always_inline]] inline std::size_t for_faces(const BandFaces& band, std::size_t from, Clear clear,
                                                    Hazy hazy) {
    constexpr std::size_t faces_ahead = 12; // they stand far apart
    std::uint32_t begin = from == 0 ? 0 : band.faces[from - 1].end;
    for (std::size_t k = from; k < band.faces.size(); ++k) {
        if (k + faces_ahead < band.faces.size()) {
            prefetch(&band.shadings[band.faces[k + faces_ahead].face]);
            if (!band.air.empty()) prefetch(&band.air[band.faces[k + faces_ahead].face]);
        }
        const std::uint32_t rank = band.faces[k].face;
        const FaceShading& shading = band.shadings[rank];
        const bool in_air = !band.air.empty() && band.air[rank].kind != AirKind::clear;
        if (shading.coloured || (in_air && band.air[rank].kind == AirKind::by_pixel)) return k;
        const std::span<const Segment> runs = band.segments.subspan(begin, band.faces[k].end - begin);
        begin = band.faces[k].end;
        if (in_air) {
            hazy(runs, band.colours[shading.colour], shading.plane, band.air[rank].transmission);
        } else {
            clear(runs, band.colours[shading.colour], shading.plane);
        }
    }
    return band.faces.size();
}

void fill_plainly(std::uint32_t pixel, std::span<const Segment> runs, const BandPixels& pixels) {
    for (const Segment& run : runs)
        std::fill_n(pixels.at(run), run.count, pixel);
}

void shade_plainly_in_haze(const IntensityPlane& plane, Colour colour, const IntensityPlane& transmission,
                           Colour horizon, std::span<const Segment> runs, const BandPixels& pixels) {
    shade_one_by_one(plane, runs, pixels,
                     [&](std::int32_t line, std::int32_t element, std::int32_t intensity) {
                         return shade_through_air(colour, intensity,
                                                  planar_transmission(transmission, line, element), horizon);
                     });
}

void shade_plainly_in_air(const IntensityPlane& plane, Colour colour, const DepthPlane& depth, const Air& air,
                          std::span<const Segment> runs, const BandPixels& pixels) {
    AirSamples samples;
    while (!runs.empty()) {
        const std::span<const Segment> planned = runs.first(samples.plan(runs, depth, air));
        samples.work_out();
        for (std::size_t r = 0; r < planned.size(); ++r) {
            const Stretches& stretches = samples.of_run[r];
            shade_one_by_one(plane, planned.subspan(r, 1), pixels,
                             [&](std::int32_t line, std::int32_t element, std::int32_t intensity) {
                                 const std::int32_t t =
                                     stretches.straight()
                                         ? samples.between(stretches, element - planned[r].first)
                                         : transmission_of(depth, air, line, element);
                                 return shade_through_air(colour, intensity, t, air.horizon());
                             });
        }
        runs = runs.subspan(planned.size());
    }
}

std::size_t shade_faces_plainly(const BandFaces& faces, std::size_t from, const BandPixels& pixels) {
    return for_faces(
        faces, from,
        [&](std::span<const Segment> runs, Colour colour, const IntensityPlane& plane) {
            shade_plainly(plane, colour, runs, pixels);
        },
        [&](std::span<const Segment> runs, Colour colour, const IntensityPlane& plane,
            const IntensityPlane& transmission) {
            shade_plainly_in_haze(plane, colour, transmission, faces.horizon, runs, pixels);
        });
}

} // namespace
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

using I32 = hn::CappedTag<std::int32_t, 16>; // a vector lies inside one stretch (air_samples.h)
using U32 = hn::Repartition<std::uint32_t, I32>;
using I16 = hn::Repartition<std::int16_t, I32>;
using F32 = hn::Repartition<float, I32>;

/// A 15-bit factor in both 16-bit halves of each lane, so that one fixed-point multiplication, (a b + 2^14) >> 15,
/// makes red and green, and another blue.
HWY_INLINE hn::Vec<I16> BothHalves(hn::Vec<I32> factor) {
    return hn::BitCast(I16(), hn::Or(factor, hn::ShiftLeft<16>(factor)));
}

/// The upper 16 bits of each lane in both halves.
HWY_INLINE hn::Vec<I16> UpperHalfTwice(hn::Vec<I32> v) {
    const auto bytes = hn::Set(I32(), 0x03020302); // of each lane; the lanes' own places are added
    const auto places = hn::Mul(hn::And(hn::Iota(I32(), 0), hn::Set(I32(), 3)), hn::Set(I32(), 0x04040404));
    return hn::BitCast(I16(), hn::TableLookupBytes(v, hn::Add(bytes, places)));
}

HWY_INLINE hn::Vec<I16> Pair(int low, int high) {
    return hn::BitCast(I16(), hn::Set(I32(), low | high << 16));
}

/// Of an intensity (1.0 = 2^22): what is above brightest_shown counts as that, 32767 with 15 bits.
constexpr std::int32_t brightest_shown = (32767 << 7) + 127;

/// Intensities of consecutive pixels of a face, clamped to the corners' range, with 15 bits in both halves.
struct Intensities {
    HWY_INLINE explicit Intensities(const IntensityPlane& plane)
        : plane_(plane), least(hn::Set(I32(), std::min(plane.least, brightest_shown))),
          greatest(hn::Set(I32(), std::min(plane.greatest, brightest_shown))),
          step(hn::Set(
              I32(), static_cast<std::int32_t>(plane.along * static_cast<std::uint32_t>(hn::Lanes(I32()))))),
          ramp(hn::Mul(hn::Iota(I32(), 0), hn::Set(I32(), static_cast<std::int32_t>(plane.along)))),
          at(ramp) {}
    HWY_INLINE void Begin(std::int32_t line, std::int32_t element) {
        at = hn::Add(hn::Set(I32(), static_cast<std::int32_t>(value_at(plane_, line, element))), ramp);
    }
    HWY_INLINE hn::Vec<I16> Next() {
        const auto clamped = hn::Max(least, hn::Min(at, greatest));
        at = hn::Add(at, step);
        return UpperHalfTwice(hn::ShiftLeft<9>(clamped));
    }
    /// The same of a run that needs no clamping.
    HWY_INLINE hn::Vec<I16> NextInside() {
        const auto here = at;
        at = hn::Add(at, step);
        return UpperHalfTwice(hn::ShiftLeft<9>(here));
    }
    /// Do both ends of a run, and so all between, lie in the corners' range?
    HWY_INLINE bool Inside(std::int32_t line, std::int32_t element, std::uint32_t count) const {
        const std::int64_t first = static_cast<std::int32_t>(value_at(plane_, line, element));
        const std::int64_t last = first + std::int64_t{static_cast<std::int32_t>(plane_.along)} * (count - 1);
        return std::min(first, last) >= plane_.least &&
               std::max(first, last) <= std::min(plane_.greatest, brightest_shown);
    }
    const IntensityPlane& plane_;
    hn::Vec<I32> least, greatest, step, ramp, at;
};

/// The same of a face whose corners are equally bright.
struct LevelIntensity {
    HWY_INLINE explicit LevelIntensity(const IntensityPlane& plane)
        : level(BothHalves(hn::Set(I32(), std::min(plane.least, brightest_shown) >> 7))) {}
    HWY_INLINE void Begin(std::int32_t /*line*/, std::int32_t /*element*/) {}
    HWY_INLINE hn::Vec<I16> Next() const { return level; }
    HWY_INLINE hn::Vec<I16> NextInside() const { return level; }
    HWY_INLINE bool Inside(std::int32_t /*line*/, std::int32_t /*element*/, std::uint32_t /*count*/) const {
        return true;
    }
    hn::Vec<I16> level;
};

/// Pixels of levels: red in the lower halves of the one and green in its upper, blue in the upper halves of the other.
HWY_INLINE hn::Vec<U32> Packed(hn::Vec<I16> red_green, hn::Vec<I16> blue) {
    const U32 d;
    const auto rg = hn::BitCast(d, red_green);
    const auto rg_packed = hn::And(hn::Or(rg, hn::ShiftRight<8>(rg)), hn::Set(d, 0xffffU));
    return hn::Or(hn::Or(rg_packed, hn::BitCast(d, blue)), hn::Set(d, 0xff000000U));
}

/// Fills `count` pixels with what `next` makes, a vector at a time; nothing is written behind the last.
template <typename Next>
HWY_INLINE void FillRun(std::uint32_t* HWY_RESTRICT pixels, std::size_t count, Next next) {
    const U32 d;
    const std::size_t lanes = hn::Lanes(d);
    std::size_t k = 0;
    for (; k + lanes <= count; k += lanes)
        hn::StoreU(next(k), d, pixels + k);
    if (k < count) hn::BlendedStore(next(k), hn::FirstN(d, count - k), d, pixels + k);
}

/// The same from a boundary on, past the caches if that is asked for.
template <typename Next>
HWY_INLINE void FillLong(const BandPixels& band, std::uint32_t* HWY_RESTRICT pixels, std::size_t count,
                         Next next) {
    const U32 d;
    const std::size_t lanes = hn::Lanes(d);
    std::size_t k = 0;
    for (; band.past_caches && k + lanes <= count; k += lanes)
        hn::Stream(next(k), d, pixels + k);
    FillRun(pixels + k, count - k, [&](std::size_t more) HWY_ATTR { return next(k + more); });
}

/// Runs of this many pixels are worth a start that makes the rest of their vectors lie in one line of the cache each.
constexpr std::size_t long_run = 96;

/// Elements from `pixel` to the next that a vector may be aligned to; a whole vector if it stands there.
HWY_INLINE std::uint32_t ToAligned(const std::uint32_t* pixel) {
    const auto lanes = static_cast<std::uint32_t>(hn::Lanes(U32()));
    return lanes -
           static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(pixel) / sizeof(*pixel)) % lanes;
}

/// As shade_through_air() for each lane.
struct AirMixer {
    HWY_INLINE AirMixer(Colour colour, Colour horizon)
        : rg(Pair(colour.red << 7, colour.green << 7)), b(Pair(0, colour.blue << 7)),
          horizon_rg(Pair(horizon.red << 7, horizon.green << 7)), horizon_b(Pair(0, horizon.blue << 7)),
          half_level(hn::Set(I16(), 64)) {}
    HWY_INLINE hn::Vec<I16> Mix(hn::Vec<I16> face, hn::Vec<I16> air, hn::Vec<I16> i, hn::Vec<I16> t) const {
        const auto left = hn::MulFixedPoint15(hn::Sub(hn::MulFixedPoint15(face, i), air), t);
        return hn::ShiftRight<7>(hn::Add(left, hn::Add(air, half_level)));
    }
    HWY_INLINE hn::Vec<U32> Seen(hn::Vec<I16> i, hn::Vec<I16> t) const {
        return Packed(Mix(rg, horizon_rg, i, t), Mix(b, horizon_b, i, t));
    }
    hn::Vec<I16> rg, b, horizon_rg, horizon_b, half_level;
};

/// As transmission_through(); Mul and Add stay apart.
HWY_INLINE hn::Vec<I32> Transmission(hn::Vec<F32> rays, hn::Vec<F32> inverse) {
    const F32 d;
    const auto octaves =
        hn::Min(hn::Div(rays, hn::Max(inverse, hn::Set(d, least_inverse))), hn::Set(d, most_octaves));
    const auto whole = hn::ConvertTo(I32(), octaves);
    const auto part = hn::Sub(octaves, hn::ConvertTo(d, whole));
    auto power = hn::Set(d, falling_octave[4]);
    for (int c = 3; c >= 0; --c)
        power = hn::Add(hn::Mul(power, part), hn::Set(d, falling_octave[static_cast<std::size_t>(c)]));
    const auto halved = hn::BitCast(d, hn::Sub(hn::BitCast(I32(), power), hn::ShiftLeft<23>(whole)));
    return hn::ConvertTo(
        I32(), hn::Add(hn::Mul(halved, hn::Set(d, static_cast<float>(transmission_one))), hn::Set(d, 0.5F)));
}

/// 1/z, range and transmission of a run inside one block of elements.
struct Transmissions {
    HWY_INLINE explicit Transmissions(const InverseRange& range)
        : start(hn::Set(F32(), range.start)), along(hn::Set(F32(), range.along)), offset(hn::Iota(F32(), 0)),
          first(static_cast<float>(range.offset)), rays(range.rays) {}
    HWY_INLINE hn::Vec<I16> At(std::size_t k) const {
        const F32 d;
        const auto here = hn::Add(offset, hn::Set(d, first + static_cast<float>(k)));
        const auto there = hn::LoadU(d, rays + k); // behind the last line there is room for a vector
        return BothHalves(Transmission(there, hn::Add(start, hn::Mul(here, along))));
    }
    hn::Vec<F32> start, along, offset;
    float first;
    const float* rays;
};

/// As AirSamples::work_out().
HWY_INLINE void WorkOut(AirSamples& samples) {
    const F32 d;
    for (std::size_t k = 0; k < samples.count; k += hn::Lanes(d)) {
        const auto transmission =
            Transmission(hn::Load(d, samples.rays.data() + k), hn::Load(d, samples.inverse.data() + k));
        hn::Store(transmission, I32(), samples.transmissions.data() + k);
    }
}

/// As AirSamples::between() along one stretch.
struct StraightTransmissions {
    HWY_INLINE StraightTransmissions(const std::int32_t* ends, int bits) {
        const I32 d;
        const std::uint32_t slope = static_cast<std::uint32_t>(ends[1] - ends[0]) << (16 - bits);
        const auto start = hn::Set(d, (ends[0] << 16) + (1 << 15));
        at = hn::Add(start, hn::Mul(hn::Iota(d, 0), hn::Set(d, static_cast<std::int32_t>(slope))));
        step = hn::Set(d, static_cast<std::int32_t>(slope * static_cast<std::uint32_t>(hn::Lanes(d))));
    }
    HWY_INLINE hn::Vec<I16> Next() {
        const auto here = at;
        at = hn::Add(at, step);
        return UpperHalfTwice(here);
    }
    hn::Vec<I32> at, step; ///< 31 bits
};

/// Starts a long run with a vector of its own, so that what follows stands at a boundary; how many elements are done by it.
template <typename Next>
HWY_INLINE std::uint32_t StartRun(std::uint32_t* pixels, Next next) {
    hn::StoreU(next(0), U32(), pixels);
    return ToAligned(pixels);
}

void ShadeRuns(const IntensityPlane& plane, Colour colour, const Segment* run, std::size_t runs,
               const BandPixels& pixels) {
    const auto red_green = Pair(colour.red, colour.green);
    const auto blue = Pair(0, colour.blue);
    Intensities intensities(plane);
    const auto shaded = [&](hn::Vec<I16> i) HWY_ATTR {
        return Packed(hn::MulFixedPoint15(i, red_green), hn::MulFixedPoint15(i, blue));
    };
    const auto next = [&](std::size_t) HWY_ATTR { return shaded(intensities.Next()); };
    const auto next_inside = [&](std::size_t) HWY_ATTR { return shaded(intensities.NextInside()); };
    for (const Segment* end = run + runs; run != end; ++run) {
        std::uint32_t* const pixel = pixels.at(*run);
        intensities.Begin(run->line, run->first);
        if (run->count < long_run) {
            FillRun(pixel, run->count, next);
            continue;
        }
        const std::uint32_t done = StartRun(pixel, next);
        const auto element = static_cast<std::int32_t>(run->first + done);
        intensities.Begin(run->line, element);
        if (intensities.Inside(run->line, element, run->count - done)) {
            FillLong(pixels, pixel + done, run->count - done, next_inside);
        } else {
            FillRun(pixel + done, run->count - done, next);
        }
    }
}

void FillRuns(std::uint32_t value, const Segment* run, std::size_t runs, const BandPixels& pixels) {
    const auto next = [value](std::size_t) HWY_ATTR { return hn::Set(U32(), value); };
    for (const Segment* end = run + runs; run != end; ++run) {
        std::uint32_t* const pixel = pixels.at(*run);
        if (run->count < long_run) {
            FillRun(pixel, run->count, next);
            continue;
        }
        const std::uint32_t done = StartRun(pixel, next);
        FillLong(pixels, pixel + done, run->count - done, next);
    }
}

template <typename Intensity>
HWY_INLINE void ShadeHazy(const IntensityPlane& plane, Colour colour, const IntensityPlane& transmission,
                          Colour horizon, const Segment* run, std::size_t runs, const BandPixels& pixels) {
    const AirMixer mixer(colour, horizon);
    Intensity intensity(plane);
    Intensities left(transmission);
    const auto next = [&](std::size_t) HWY_ATTR { return mixer.Seen(intensity.Next(), left.Next()); };
    const auto next_inside = [&](std::size_t)
                                 HWY_ATTR { return mixer.Seen(intensity.NextInside(), left.NextInside()); };
    for (const Segment* end = run + runs; run != end; ++run) {
        std::uint32_t* const pixel = pixels.at(*run);
        intensity.Begin(run->line, run->first);
        left.Begin(run->line, run->first);
        if (run->count < long_run) {
            FillRun(pixel, run->count, next);
            continue;
        }
        const std::uint32_t done = StartRun(pixel, next), count = run->count - done;
        const auto element = static_cast<std::int32_t>(run->first + done);
        intensity.Begin(run->line, element);
        left.Begin(run->line, element);
        if (intensity.Inside(run->line, element, count) && left.Inside(run->line, element, count)) {
            FillLong(pixels, pixel + done, count, next_inside);
        } else {
            FillRun(pixel + done, count, next);
        }
    }
}

void ShadeRunsInHaze(const IntensityPlane& plane, Colour colour, const IntensityPlane& transmission,
                     Colour horizon, const Segment* run, std::size_t runs, const BandPixels& pixels) {
    if (!is_level(plane)) {
        ShadeHazy<Intensities>(plane, colour, transmission, horizon, run, runs, pixels);
    } else if (transmission.along != 0 || transmission.across != 0) {
        ShadeHazy<LevelIntensity>(plane, colour, transmission, horizon, run, runs, pixels);
    } else {
        const std::int32_t t =
            planar_transmission(transmission, transmission.reference_line, transmission.reference_element);
        FillRuns(shade_through_air(colour, plane.least, t, horizon), run, runs, pixels);
    }
}

std::size_t ShadeFaces(const BandFaces& faces, std::size_t from, const BandPixels& pixels) {
    return for_faces(
        faces, from,
        [&](std::span<const Segment> runs, Colour colour, const IntensityPlane& plane) HWY_ATTR {
            if (is_level(plane)) {
                FillRuns(shade(colour, plane.least), runs.data(), runs.size(), pixels);
            } else {
                ShadeRuns(plane, colour, runs.data(), runs.size(), pixels);
            }
        },
        [&](std::span<const Segment> runs, Colour colour, const IntensityPlane& plane,
            const IntensityPlane& transmission) HWY_ATTR {
            ShadeRunsInHaze(plane, colour, transmission, faces.horizon, runs.data(), runs.size(), pixels);
        });
}

/// A run, its transmission taken at every pixel.
template <typename Intensity>
HWY_INLINE void ShadeExactly(Intensity& intensity, const AirMixer& mixer, const DepthPlane& depth,
                             const Air& air, const Segment& run, const BandPixels& pixels) {
    const std::int32_t end = run.first + run.count;
    for (std::int32_t element = run.first, stop = 0; element < end; element = stop) {
        stop = std::min(end, (element & ~(block_elements - 1)) + block_elements);
        const Transmissions transmissions(inverse_range(depth, air, run.line, element));
        intensity.Begin(run.line, element);
        FillRun(pixels.at(run.line, static_cast<std::uint32_t>(element)),
                static_cast<std::size_t>(stop - element),
                [&](std::size_t k) HWY_ATTR { return mixer.Seen(intensity.Next(), transmissions.At(k)); });
    }
}

/// A run, its transmission straight from sample to sample.
template <typename Intensity>
HWY_INLINE void ShadeStretches(Intensity& intensity, const AirMixer& mixer, const AirSamples& samples,
                               const Stretches& stretches, const Segment& run, const BandPixels& pixels) {
    std::uint32_t* const pixel = pixels.at(run);
    const std::int32_t* ends = samples.transmissions.data() + stretches.first_sample;
    intensity.Begin(run.line, run.first);
    for (std::uint32_t k = 0; k < run.count; k += 1U << stretches.bits, ++ends) {
        StraightTransmissions transmissions(ends, stretches.bits);
        FillRun(pixel + k, std::min(run.count - k, 1U << stretches.bits),
                [&](std::size_t) HWY_ATTR { return mixer.Seen(intensity.Next(), transmissions.Next()); });
    }
}

template <typename Intensity>
HWY_INLINE void ShadeInAir(const IntensityPlane& plane, Colour colour, const DepthPlane& depth,
                           const Air& air, std::span<const Segment> runs, const BandPixels& pixels) {
    const AirMixer mixer(colour, air.horizon());
    Intensity intensity(plane);
    AirSamples samples;
    while (!runs.empty()) {
        const std::size_t planned = samples.plan(runs, depth, air);
        WorkOut(samples);
        for (std::size_t r = 0; r < planned; ++r) {
            if (!samples.of_run[r].straight()) {
                ShadeExactly(intensity, mixer, depth, air, runs[r], pixels);
                continue;
            }
            ShadeStretches(intensity, mixer, samples, samples.of_run[r], runs[r], pixels);
        }
        runs = runs.subspan(planned);
    }
}

void ShadeRunsInAir(const IntensityPlane& plane, Colour colour, const DepthPlane& depth, const Air& air,
                    const Segment* run, std::size_t runs, const BandPixels& pixels) {
    if (plane.least == plane.greatest) {
        ShadeInAir<LevelIntensity>(plane, colour, depth, air, {run, runs}, pixels);
    } else {
        ShadeInAir<Intensities>(plane, colour, depth, air, {run, runs}, pixels);
    }
}

#else // one lane has no 16-bit halves

std::size_t ShadeFaces(const BandFaces& faces, std::size_t from, const BandPixels& pixels) {
    return shade_faces_plainly(faces, from, pixels);
}

void ShadeRuns(const IntensityPlane& plane, Colour colour, const Segment* run, std::size_t runs,
               const BandPixels& pixels) {
    shade_plainly(plane, colour, {run, runs}, pixels);
}
void FillRuns(std::uint32_t value, const Segment* run, std::size_t runs, const BandPixels& pixels) {
    fill_plainly(value, {run, runs}, pixels);
}
void ShadeRunsInHaze(const IntensityPlane& plane, Colour colour, const IntensityPlane& transmission,
                     Colour horizon, const Segment* run, std::size_t runs, const BandPixels& pixels) {
    shade_plainly_in_haze(plane, colour, transmission, horizon, {run, runs}, pixels);
}
void ShadeRunsInAir(const IntensityPlane& plane, Colour colour, const DepthPlane& depth, const Air& air,
                    const Segment* run, std::size_t runs, const BandPixels& pixels) {
    shade_plainly_in_air(plane, colour, depth, air, {run, runs}, pixels);
}

#endif

} // namespace HWY_NAMESPACE
} // namespace linkdig::ig
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace linkdig::ig {

namespace {

HWY_EXPORT(FillRuns);
HWY_EXPORT(ShadeFaces);
HWY_EXPORT(ShadeRunsInAir);

} // namespace

void settle_pixels(const BandPixels& pixels) {
    if (pixels.past_caches) hwy::FlushStream();
}

std::size_t shade_faces(const BandFaces& faces, std::size_t from, const BandPixels& pixels) {
    return simd_is_off() ? shade_faces_plainly(faces, from, pixels)
                         : HWY_DYNAMIC_DISPATCH(ShadeFaces)(faces, from, pixels);
}

void fill_runs(std::uint32_t pixel, std::span<const Segment> runs, const BandPixels& pixels) {
    if (simd_is_off()) {
        fill_plainly(pixel, runs, pixels);
    } else {
        HWY_DYNAMIC_DISPATCH(FillRuns)(pixel, runs.data(), runs.size(), pixels);
    }
}

void shade_runs_in_air(const IntensityPlane& plane, Colour colour, const DepthPlane& depth, const Air& air,
                       std::span<const Segment> runs, const BandPixels& pixels) {
    if (simd_is_off()) {
        shade_plainly_in_air(plane, colour, depth, air, runs, pixels);
    } else {
        HWY_DYNAMIC_DISPATCH(ShadeRunsInAir)(plane, colour, depth, air, runs.data(), runs.size(), pixels);
    }
}

} // namespace linkdig::ig
#endif
