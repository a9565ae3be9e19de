#ifndef LINKDIG_SMOOTHED_LINES_ONCE
#define LINKDIG_SMOOTHED_LINES_ONCE
#include "ig/scanline/smoothed_lines.h"

#include "ig/scanline/open_mask.h"

#include <algorithm>
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

/// A bit for each of the lines; there is one.
[[maybe_unused]] std::uint32_t bits_of(const LineRange& lines) {
    return ~0U << lines.from & ~0U >> (band_lines - lines.to);
}

/// Where the edges of one side run on the band's lines: the elements that they cross, and the height of the line that they span.
struct TracedSide {
    alignas(64) std::array<std::int32_t, band_lines> begin, end, height;
};

/// The pieces of a face's outline on the band's lines, as EdgePiece; height 0: none there. Room for a vector behind the last line
/// is not needed: vectors begin where a multiple of their lines does.
struct TracedFace {
    std::array<TracedSide, 2> sides; ///< leading, trailing
    alignas(64) std::array<std::array<std::int32_t, band_lines>, most_outlines> left, right, rise, height;
    std::array<std::int32_t, most_outlines> side;
    std::uint32_t outlines = 0;
};

/// One line of a band, as a face changes it.
struct SmoothedLine {
    std::size_t index = 0; ///< in the band
    LineMask open;
    std::uint64_t* shared = nullptr;
    std::uint32_t* left = nullptr;
    std::uint16_t number = 0;
    std::uint32_t closed = 0; ///< elements
};

/// Elements [begin, end) of a line.
struct Reach {
    std::int32_t begin = 0;
    std::int32_t end = 0;
    std::int32_t width() const { return end - begin; }
};

} // namespace
} // namespace linkdig::ig
#endif

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "ig/scanline/smoothed_lines.cpp"
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

#if HWY_TARGET != HWY_SCALAR && HWY_TARGET != HWY_EMU128

// ---- where the outline runs ----------------------------------------------------------------------------------------

using I64 = hn::CappedTag<std::int64_t, 8>;
using U64 = hn::Rebind<std::uint64_t, I64>;
using L32 = hn::Rebind<std::int32_t, I64>; ///< a line in each lane

HWY_INLINE hn::Vec<L32> Position(hn::Vec<I64> at) {
    const auto whole = hn::BitCast(U64(), hn::ShiftRight<outline_bits>(at));
    return hn::BitCast(L32(), hn::TruncateTo(hn::Rebind<std::uint32_t, I64>(), whole));
}

/// As trace_line() for one edge, on the lines [from, to) of the band.
HWY_INLINE void TraceEdge(const OutlineEdge& edge, std::int32_t first_line, std::size_t from, std::size_t to,
                          std::size_t k, TracedFace& traced) {
    const I64 d;
    const L32 dl;
    TracedSide& side = traced.sides[edge.sign > 0 ? 0 : 1];
    traced.side[k] = edge.sign;
    const auto upper_line = hn::Set(dl, edge.upper_line), lower_line = hn::Set(dl, edge.lower_line);
    const auto slope = hn::Set(d, edge.slope);
    for (std::size_t line = from; line < to; line += hn::Lanes(d)) {
        const auto number = first_line + static_cast<std::int32_t>(line);
        const auto steps = hn::Add(hn::Iota(d, 0), hn::Set(d, std::int64_t{number} - edge.first_border));
        const auto at = hn::Add(hn::Set(d, edge.start), hn::Mul(steps, slope));
        const auto top = hn::ShiftLeft<8>(hn::Add(hn::Iota(dl, 0), hn::Set(dl, number)));
        const auto bottom = hn::Add(top, hn::Set(dl, 256));
        const auto upper =
            hn::IfThenElse(hn::Lt(upper_line, top), Position(at), hn::Set(dl, edge.upper_element));
        const auto lower = hn::IfThenElse(hn::Gt(lower_line, bottom), Position(hn::Add(at, slope)),
                                          hn::Set(dl, edge.lower_element));
        const auto height =
            hn::Max(hn::Sub(hn::Min(lower_line, bottom), hn::Max(upper_line, top)), hn::Zero(dl));
        const auto left = hn::Min(upper, lower), right = hn::Max(upper, lower);
        hn::Store(left, dl, traced.left[k].data() + line);
        hn::Store(right, dl, traced.right[k].data() + line);
        hn::Store(hn::IfThenElse(hn::Gt(upper, lower), hn::Neg(height), height), dl,
                  traced.rise[k].data() + line);
        hn::Store(height, dl, traced.height[k].data() + line);

        const auto there = hn::Gt(height, hn::Zero(dl));
        const auto begin = hn::IfThenElse(there, hn::ShiftRight<8>(left), hn::Set(dl, INT32_MAX));
        const auto end =
            hn::IfThenElse(there, hn::Add(hn::ShiftRight<8>(right), hn::Set(dl, 1)), hn::Set(dl, INT32_MIN));
        hn::Store(hn::Min(hn::Load(dl, side.begin.data() + line), begin), dl, side.begin.data() + line);
        hn::Store(hn::Max(hn::Load(dl, side.end.data() + line), end), dl, side.end.data() + line);
        hn::Store(hn::Add(hn::Load(dl, side.height.data() + line), height), dl, side.height.data() + line);
    }
}

HWY_INLINE void TraceFace(const FaceEdges& edges, const EdgeFace& face, std::int32_t first_line,
                          std::size_t from, std::size_t to, TracedFace& traced) {
    const L32 d;
    for (TracedSide& side : traced.sides)
        for (std::size_t line = from; line < to; line += hn::Lanes(d)) {
            hn::Store(hn::Set(d, INT32_MAX), d, side.begin.data() + line);
            hn::Store(hn::Set(d, INT32_MIN), d, side.end.data() + line);
            hn::Store(hn::Zero(d), d, side.height.data() + line);
        }
    traced.outlines = face.outlines;
    for (std::size_t k = 0; k < face.outlines; ++k)
        TraceEdge(edges.outlines[face.first_outline + k], first_line, from, to, k, traced);
}

// ---- areas ---------------------------------------------------------------------------------------------------------

/// A piece of an edge, for all elements.
struct Piece {
    HWY_INLINE Piece(const TracedFace& traced, std::size_t edge, std::size_t line)
        : left(hn::Set(I32(), traced.left[edge][line])), right(hn::Set(I32(), traced.right[edge][line])),
          height(hn::Set(I32(), traced.height[edge][line])),
          length(hn::ConvertTo(F32(), hn::Sub(right, left))),
          twice(hn::Max(hn::Add(length, length), hn::Set(F32(), 1.0F))),
          rise(hn::ConvertTo(F32(), hn::Set(I32(), 2 * traced.rise[edge][line]))) {}

    /// How far across the line it has got at `x`, 1/256: as passed_at(), nought before it and its height behind it. Numerator
    /// and denominator are whole numbers below 2^23 and 2^15 on a narrow line, and exact; the quotient, below 2^9, is whole or
    /// more than 2^-15 from whole numbers, and rounded by at most 2^-16.
    HWY_INLINE V Passed(V x) const {
        const F32 d;
        const auto run =
            hn::ConvertTo(d, hn::Min(hn::Max(hn::Sub(x, left), hn::Zero(I32())), hn::Sub(right, left)));
        const auto rounded = hn::Add(hn::Mul(run, rise), length);
        const auto other_way = hn::Sub(hn::Sub(twice, hn::Set(d, 1.0F)), rounded);
        const auto numerator = hn::IfThenElse(hn::Lt(rounded, hn::Zero(d)), other_way, rounded);
        const auto passed = hn::ConvertTo(I32(), hn::Div(numerator, twice));
        return hn::IfThenElse(hn::Lt(x, right), passed, height);
    }

    /// What it adds to the elements whose left borders are `x`: the area of the line to its right. `passed` and `then`: at those
    /// borders, and at the next.
    HWY_INLINE V Area(V x, V passed, V then) const {
        const I32 d;
        const auto element = hn::Set(d, 256);
        const auto enters = hn::Max(hn::Sub(left, x), hn::Zero(d));
        const auto leaves = hn::Min(hn::Sub(right, x), element);
        const auto sides = hn::Sub(hn::Sub(hn::Set(d, 512), enters), leaves);
        return hn::Add(hn::ShiftLeft<9>(passed), hn::Mul(hn::Sub(then, passed), sides));
    }

    V left, right, height;
    hn::Vec<F32> length, twice, rise;
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

/// Which elements of a window are some, and which whole.
struct Covered {
    Window some = 0;
    Window whole = 0;
};

/// Areas of the elements of a line, clamped to the pixel, from the edges of these sides (0: both).
HWY_INLINE Covered Cover(const TracedFace& traced, std::size_t line, Reach reach, std::int32_t side,
                         Areas& areas) {
    const I32 d;
    const auto lanes = static_cast<std::int32_t>(hn::Lanes(d));
    const auto all = hn::Set(d, static_cast<std::int32_t>(whole_pixel));
    // Of each lane the next one, of the last itself.
    const auto next_lane =
        hn::IndicesFromVec(d, hn::Min(hn::Add(hn::Iota(d, 0), hn::Set(d, 1)), hn::Set(d, lanes - 1)));
    const bool one_vector = reach.width() < lanes; // then each element's next border is in the next lane
    Covered covered;
    for (std::int32_t k = 0; k < reach.width(); k += lanes) {
        const auto x = hn::ShiftLeft<8>(hn::Add(hn::Iota(d, 0), hn::Set(d, reach.begin + k)));
        auto area = side < 0 ? all : hn::Zero(d);
        for (std::size_t edge = 0; edge < traced.outlines; ++edge) {
            if (traced.height[edge][line] == 0 || traced.side[edge] == -side) continue;
            const Piece piece(traced, edge, line);
            const auto passed = piece.Passed(x);
            const auto then = one_vector ? hn::TableLookupLanes(passed, next_lane)
                                         : piece.Passed(hn::Add(x, hn::Set(d, 256)));
            const auto more = piece.Area(x, passed, then);
            area = traced.side[edge] > 0 ? hn::Add(area, more) : hn::Sub(area, more);
        }
        area = hn::Min(hn::Max(area, hn::Zero(d)), all);
        hn::Store(area, d, areas.data() + k);
        covered.some |= Bits(hn::Gt(area, hn::Zero(d))) << static_cast<std::uint32_t>(k);
        covered.whole |= Bits(hn::Eq(area, all)) << static_cast<std::uint32_t>(k);
    }
    return covered;
}

// ---- shares --------------------------------------------------------------------------------------------------------

/// Shares of the elements `mine`, the highest of which is below `count`: the areas, at most what is left of each. Returns which
/// of them are closed now.
HWY_INLINE Window Share(const Areas& areas, Window mine, std::size_t count, std::uint32_t* left,
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

/// One run for all shares of a window that begins at `first`; the elements that are closed by them are open no more.
HWY_INLINE void PutShares(const Areas& areas, Window mine, std::uint32_t first, std::uint32_t rank,
                          SmoothedLine& line, BandSegments& band) {
    const auto from = static_cast<std::uint32_t>(std::countr_zero(mine));
    const auto end = word_bits - static_cast<std::uint32_t>(std::countl_zero(mine));
    const std::size_t weights = band.weights.size();
    band.weights.resize(weights + end + weights_padding);
    const Window closed = Share(areas, mine, end, line.left + first, band.weights.data() + weights);
    band.weights.resize(weights + end);
    band.shares.push_back({rank, static_cast<std::uint32_t>(weights) + from, line.number,
                           static_cast<std::uint16_t>(first + from), static_cast<std::uint16_t>(end - from)});
    flip_bits(line.open, first, closed);
    line.closed += static_cast<std::uint32_t>(std::popcount(closed));
}

HWY_INLINE void PutAlone(Window alone, std::uint32_t first, SmoothedLine& line, BandSegments& band) {
    flip_bits(line.open, first, alone);
    line.closed += static_cast<std::uint32_t>(std::popcount(alone));
    while (alone != 0) {
        const BitRun run = take_run(alone);
        band.segments.push_back({line.number, static_cast<std::uint16_t>(first + run.first),
                                 static_cast<std::uint16_t>(run.count())});
        ++band.on_line[line.index];
    }
}

// ---- lines ---------------------------------------------------------------------------------------------------------

/// The sides of a face on a line.
struct Sides {
    Reach leading, trailing;
    bool apart = false; ///< each of them spans the whole line, and the one ends before the other begins
};

/// The same, if there are any, of elements that need not have been shared before.
HWY_INLINE void PutNewShares(const Areas& areas, Window mine, std::uint32_t first, std::uint32_t rank,
                             SmoothedLine& line, BandSegments& band) {
    if (mine == 0) return;
    or_bits(line.shared, first, mine);
    PutShares(areas, mine, first, rank, line, band);
}

/// A line on which the face lies in one window.
HWY_INLINE void PutNarrow(const TracedFace& traced, const Sides& sides, Reach reach, std::uint32_t rank,
                          SmoothedLine& line, BandSegments& band) {
    const auto first = static_cast<std::uint32_t>(reach.begin);
    const Window open = window_at(line.open, first) & window_bits(reach.begin, reach.end, reach.begin);
    if (open == 0) return;
    alignas(64) Areas areas;
    const Covered covered = Cover(traced, line.index, reach, 0, areas);
    if (!sides.apart) {
        PutNewShares(areas, trimmed(open, covered.some), first, rank, line, band);
        return;
    }
    const Window partly = open & ~covered.whole, wholly = open & covered.whole;
    const Window begins = window_bits(sides.leading.begin, sides.leading.end, reach.begin);
    const Window ends = window_bits(sides.trailing.begin, sides.trailing.end, reach.begin);
    const Window rests = wholly == 0 ? 0 : wholly & window_at(line.shared, first); // what others have left
    const Window newly = trimmed(partly & begins, covered.some) | trimmed(partly & ends, covered.some);
    PutNewShares(areas, newly | rests, first, rank, line, band);
    PutAlone(wholly ^ rests, first, line, band);
}

/// The elements that one side crosses, the others of the line being left out; which of them are covered wholly.
HWY_INLINE Window PutSide(const TracedFace& traced, Reach reach, std::int32_t side, std::uint32_t rank,
                          SmoothedLine& line, BandSegments& band) {
    const auto first = static_cast<std::uint32_t>(reach.begin);
    alignas(64) Areas areas;
    const Covered covered = Cover(traced, line.index, reach, side, areas);
    const Window all = window_bits(reach.begin, reach.end, reach.begin);
    const Window open = window_at(line.open, first) & all & ~covered.whole;
    PutNewShares(areas, trimmed(open, covered.some), first, rank, line, band);
    return covered.whole & all;
}

/// A line on which few elements are crossed on each side; returns what lies between, wholly covered.
HWY_INLINE Reach PutSides(const TracedFace& traced, const Sides& sides, std::uint32_t rank,
                          SmoothedLine& line, BandSegments& band) {
    const Window begins = PutSide(traced, sides.leading, 1, rank, line, band);
    const Window ends = PutSide(traced, sides.trailing, -1, rank, line, band);
    return {sides.leading.end - std::popcount(begins), sides.trailing.begin + std::popcount(ends)};
}

HWY_INLINE Sides SidesOf(const TracedFace& traced, std::size_t line) {
    const TracedSide &leading = traced.sides[0], &trailing = traced.sides[1];
    return {{leading.begin[line], leading.end[line]},
            {trailing.begin[line], trailing.end[line]},
            leading.end[line] <= trailing.begin[line] &&
                512 * leading.height[line] == static_cast<std::int32_t>(whole_pixel)};
}

void PutSmoothedLines(const FaceEdges& edges, std::uint32_t rank, const SmoothedBand& smoothed,
                      BandSegments& out, LinesLeft& left) {
    const EdgeFace& face = edges.faces[rank];
    OpenBand& band = *smoothed.open;
    const std::size_t lanes = hn::Lanes(L32());
    const auto [from, to] = band.lines_of(face);
    TracedFace traced; // not written: what is read is traced first
    TraceFace(edges, face, band.first_line, from / lanes * lanes, to, traced);
    left.whole = left.wide = 0;
    for (std::size_t index = from; index < to; ++index) {
        if (band.count[index] == 0 || traced.sides[0].height[index] == 0) continue;
        const Sides sides = SidesOf(traced, index);
        const Reach reach{std::min(sides.leading.begin, sides.trailing.begin),
                          std::max(sides.leading.end, sides.trailing.end)};
        SmoothedLine line{index, band.line(index), smoothed.shared + index * smoothed.words,
                          smoothed.left + index * static_cast<std::size_t>(smoothed.elements),
                          static_cast<std::uint16_t>(band.first_line + static_cast<std::int32_t>(index))};
        const bool within = reach.begin >= 0 && reach.end <= smoothed.elements;
        const std::int32_t between = sides.trailing.begin - sides.leading.end;
        if (within && reach.width() <= narrow_elements &&
            (reach.width() <= few_elements || between <= few_elements)) {
            PutNarrow(traced, sides, reach, rank, line, out);
        } else if (within && sides.apart && sides.leading.width() <= few_elements &&
                   sides.trailing.width() <= few_elements) {
            const Reach whole = PutSides(traced, sides, rank, line, out);
            left.begin[index] = whole.begin;
            left.end[index] = whole.end;
            left.whole |= whole.begin < whole.end ? 1U << index : 0U;
        } else {
            left.wide |= 1U << index;
            continue;
        }
        band.count[index] -= line.closed;
        band.open_lines -= line.closed != 0 && band.count[index] == 0 ? 1 : 0;
    }
}

#else

void PutSmoothedLines(const FaceEdges& edges, std::uint32_t rank, const SmoothedBand& smoothed,
                      BandSegments& /*out*/, LinesLeft& left) {
    left.whole = 0;
    left.wide = bits_of(smoothed.open->lines_of(edges.faces[rank]));
}

#endif

} // namespace HWY_NAMESPACE
} // namespace linkdig::ig
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace linkdig::ig {

namespace {

HWY_EXPORT(PutSmoothedLines);

} // namespace

void put_smoothed_lines(const FaceEdges& edges, std::uint32_t rank, const SmoothedBand& band,
                        BandSegments& segments, LinesLeft& left) {
    HWY_DYNAMIC_DISPATCH(PutSmoothedLines)(edges, rank, band, segments, left);
}

} // namespace linkdig::ig
#endif
