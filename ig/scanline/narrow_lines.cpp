#ifndef LINKDIG_NARROW_LINES_ONCE
#define LINKDIG_NARROW_LINES_ONCE
#include "ig/scanline/narrow_lines.h"

#include "ig/scanline/open_mask.h"

#include <array>
#include <bit>

namespace linkdig::ig {
namespace {

/// A bit per element from the first one on that a face reaches.
using Window = std::uint64_t;

template <typename Bits>
Window window_at(const Bits& bits, std::uint32_t first) {
    const std::uint32_t word = first / word_bits, shift = first % word_bits;
    Window found = bits[word] >> shift;
    if (shift > word_bits - narrow_elements) found |= bits[word + 1] << (word_bits - shift);
    return found;
}

void flip_bits(const LineMask& bits, std::uint32_t first, Window flipped) {
    const std::uint32_t word = first / word_bits, shift = first % word_bits;
    bits[word] ^= flipped << shift;
    if (shift > word_bits - narrow_elements) bits[word + 1] ^= flipped >> (word_bits - shift);
}

void or_bits(std::uint64_t* bits, std::uint32_t first, Window set) {
    const std::uint32_t word = first / word_bits, shift = first % word_bits;
    bits[word] |= set << shift;
    if (shift > word_bits - narrow_elements) bits[word + 1] |= set >> (word_bits - shift);
}

/// Bits [begin, end) of a window that begins at `first`.
Window window_bits(std::int32_t begin, std::int32_t end, std::int32_t first) {
    return (Window{1} << static_cast<std::uint32_t>(end - first)) -
           (Window{1} << static_cast<std::uint32_t>(begin - first));
}

/// Of each run of set bits in `runs` the part between the first and the last that is set in `some`.
Window trimmed(Window runs, Window some) {
    Window kept = 0;
    while (runs != 0) {
        const BitRun run = take_run(runs);
        const Window mine = some & ((Window{1} << run.end) - (Window{1} << run.first));
        if (mine != 0)
            kept |= (Window{2} << static_cast<std::uint32_t>(63 - std::countl_zero(mine))) - (mine & -mine);
    }
    return kept;
}

} // namespace
} // namespace linkdig::ig
#endif

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "ig/scanline/narrow_lines.cpp"
#include <hwy/foreach_target.h> // compiles this file once for every SIMD level
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace linkdig::ig {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using I32 = hn::CappedTag<std::int32_t, 16>;
using U32 = hn::Rebind<std::uint32_t, I32>;
using F32 = hn::Rebind<float, I32>;
using V = hn::Vec<I32>;

/// A piece of an edge, for all elements.
struct Piece {
    HWY_INLINE explicit Piece(const EdgePiece& piece)
        : left(hn::Set(I32(), piece.left)), right(hn::Set(I32(), piece.right)),
          height(hn::Set(I32(), piece.height)),
          length(hn::Set(F32(), static_cast<float>(piece.right - piece.left))),
          twice(hn::Max(hn::Add(length, length), hn::Set(F32(), 1.0F))),
          twice_rise(hn::Set(F32(), 2.0F * static_cast<float>(piece.rise))) {}

    /// How far across the line it has got at `x`, 1/256: as passed_at(), nought before it and its height behind it. Numerator
    /// and denominator are whole numbers below 2^23 and 2^15 on a narrow line, and exact; the quotient, below 2^9, is whole or
    /// more than 2^-15 from whole numbers, and rounded by at most 2^-16.
    HWY_INLINE V Passed(V x) const {
        const F32 d;
        const auto run =
            hn::ConvertTo(d, hn::Min(hn::Max(hn::Sub(x, left), hn::Zero(I32())), hn::Sub(right, left)));
        const auto rounded = hn::Add(hn::Mul(run, twice_rise), length);
        const auto other_way = hn::Sub(hn::Sub(twice, hn::Set(d, 1.0F)), rounded);
        const auto numerator = hn::IfThenElse(hn::Lt(rounded, hn::Zero(d)), other_way, rounded);
        const auto passed = hn::ConvertTo(I32(), hn::Div(numerator, twice));
        return hn::IfThenElse(hn::Lt(x, right), passed, height);
    }

    /// What it adds to the elements whose left borders are `x`: the area of the line to its right.
    HWY_INLINE V Area(V x) const {
        const I32 d;
        const auto element = hn::Set(d, 256);
        const auto passed = Passed(x);
        const auto more = hn::Sub(Passed(hn::Add(x, element)), passed);
        const auto enters = hn::Max(hn::Sub(left, x), hn::Zero(d));
        const auto leaves = hn::Min(hn::Sub(right, x), element);
        const auto sides = hn::Sub(hn::Sub(hn::Set(d, 512), enters), leaves);
        return hn::Add(hn::ShiftLeft<9>(passed), hn::Mul(more, sides));
    }

    V left, right, height;
    hn::Vec<F32> length, twice, twice_rise;
};

HWY_INLINE Window Bits(hn::Mask<I32> mask) {
    std::uint8_t bytes[8] = {};
    const std::size_t count = hn::StoreMaskBits(I32(), mask, bytes);
    return count > 1 ? bytes[0] | static_cast<Window>(bytes[1]) << 8U : bytes[0];
}

HWY_INLINE hn::Mask<U32> MaskOf(Window bits) {
    const std::uint8_t bytes[8] = {static_cast<std::uint8_t>(bits & 0xffU),
                                   static_cast<std::uint8_t>(bits >> 8U & 0xffU)};
    return hn::LoadMaskBits(U32(), bytes);
}

/// Room for the areas of a narrow line's elements.
using Areas = std::array<std::int32_t, narrow_elements>;

/// Areas of the elements of a line, clamped to the pixel, and which of them are some and which whole.
HWY_INLINE void CoverNarrow(const OutlineLine& traced, Areas& areas, Window& some, Window& whole) {
    const I32 d;
    const auto lanes = static_cast<std::int32_t>(hn::Lanes(d));
    const auto all = hn::Set(d, static_cast<std::int32_t>(whole_pixel));
    some = whole = 0;
    for (std::int32_t k = 0; k < traced.end - traced.begin; k += lanes) {
        const auto x = hn::ShiftLeft<8>(hn::Add(hn::Iota(d, 0), hn::Set(d, traced.begin + k)));
        auto area = hn::Zero(d);
        for (const EdgePiece& edge : traced.pieces) {
            const auto more = Piece(edge).Area(x);
            area = edge.sign > 0 ? hn::Add(area, more) : hn::Sub(area, more);
        }
        area = hn::Min(hn::Max(area, hn::Zero(d)), all);
        hn::Store(area, d, areas.data() + k);
        some |= Bits(hn::Gt(area, hn::Zero(d))) << static_cast<std::uint32_t>(k);
        whole |= Bits(hn::Eq(area, all)) << static_cast<std::uint32_t>(k);
    }
}

/// Shares of the elements `mine`, the highest of which is below `count`: the areas, at most what is left of each. Returns which
/// of them are closed now.
HWY_INLINE Window ShareNarrow(const Areas& areas, Window mine, std::size_t count, std::uint32_t* left,
                              std::uint32_t* weights) {
    const U32 d;
    Window closed = 0;
    for (std::size_t k = 0; k < count; k += hn::Lanes(d)) {
        const auto mask = MaskOf(mine >> k);
        const auto before = hn::LoadU(d, left + k);
        const auto area = hn::BitCast(d, hn::Load(I32(), areas.data() + k));
        const auto weight = hn::IfThenElseZero(mask, hn::Min(area, before));
        const auto rest = hn::Sub(before, weight);
        hn::StoreU(rest, d, left + k);
        hn::StoreU(weight, d, weights + k);
        closed |= Bits(hn::RebindMask(I32(), hn::Eq(rest, hn::Zero(d)))) << k;
    }
    return closed & mine;
}

/// Elements of the window that the face takes alone, and those of which it has a share.
struct Taken {
    Window alone = 0;
    Window newly_shared = 0;
    Window rests = 0; ///< what others have left of shared ones that it covers wholly
};

HWY_INLINE Taken Divide(const OutlineLine& traced, const BandLine& line, Window some, Window full) {
    const EdgeSide &leading = traced.leading, &trailing = traced.trailing;
    const auto first = static_cast<std::uint32_t>(traced.begin);
    const Window open = window_at(line.open, first) & window_bits(traced.begin, traced.end, traced.begin);
    const bool apart =
        leading.end <= trailing.begin && 512 * leading.height == static_cast<std::int32_t>(whole_pixel);
    if (!apart) return {.newly_shared = trimmed(open, some)};
    const Window partly = open & ~full, wholly = open & full;
    const Window begins = window_bits(leading.begin, leading.end, traced.begin);
    const Window ends = window_bits(trailing.begin, trailing.end, traced.begin);
    const Window rests = wholly == 0 ? 0 : wholly & window_at(line.shared, first);
    return {wholly ^ rests, trimmed(partly & begins, some) | trimmed(partly & ends, some), rests};
}

void PutAlone(Window alone, std::uint32_t first, const BandLine& line, BandSegments& band) {
    while (alone != 0) {
        const BitRun run = take_run(alone);
        band.segments.push_back({line.number, static_cast<std::uint16_t>(first + run.first),
                                 static_cast<std::uint16_t>(run.count())});
        ++band.on_line[line.number - band.first_line];
    }
}

/// One run for all shares; returns the elements that are closed by them.
HWY_INLINE Window PutShares(const Areas& areas, Window mine, std::uint32_t first, std::uint32_t rank,
                            const BandLine& line, BandSegments& band) {
    const auto from = static_cast<std::uint32_t>(std::countr_zero(mine));
    const auto end = word_bits - static_cast<std::uint32_t>(std::countl_zero(mine));
    const std::size_t weights = band.weights.size();
    band.weights.resize(weights + end + weights_padding);
    const Window closed = ShareNarrow(areas, mine, end, line.left + first, band.weights.data() + weights);
    band.weights.resize(weights + end);
    band.shares.push_back({rank, static_cast<std::uint32_t>(weights) + from, line.number,
                           static_cast<std::uint16_t>(first + from), static_cast<std::uint16_t>(end - from)});
    return closed;
}

std::uint32_t PutNarrowLine(const OutlineLine& traced, std::uint32_t rank, const BandLine& line,
                            BandSegments& band) {
    if (traced.leading.height == 0) return 0;
    const auto first = static_cast<std::uint32_t>(traced.begin);
    alignas(64) Areas areas;
    Window some = 0, full = 0;
    CoverNarrow(traced, areas, some, full);
    const Taken taken = Divide(traced, line, some, full);
    Window closed = taken.alone;
    if (const Window shared = taken.newly_shared | taken.rests; shared != 0) {
        or_bits(line.shared, first, taken.newly_shared);
        closed |= PutShares(areas, shared, first, rank, line, band);
    }
    PutAlone(taken.alone, first, line, band);
    flip_bits(line.open, first, closed);
    return static_cast<std::uint32_t>(std::popcount(closed));
}

} // namespace HWY_NAMESPACE
} // namespace linkdig::ig
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace linkdig::ig {

namespace {

HWY_EXPORT(PutNarrowLine);

} // namespace

std::uint32_t put_narrow_line(const OutlineLine& traced, std::uint32_t rank, const BandLine& line,
                              BandSegments& band) {
    return HWY_DYNAMIC_DISPATCH(PutNarrowLine)(traced, rank, line, band);
}

} // namespace linkdig::ig
#endif
