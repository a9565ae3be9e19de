#ifndef LINKDIG_OPAQUE_FACES_ONCE
#define LINKDIG_OPAQUE_FACES_ONCE
#include "ig/scanline/opaque_faces.h"

#include "ig/configuration.h"
#include "ig/scanline/fetch_ahead.h"
#include "ig/simd/simd_level.h"

#include <algorithm>
#include <bit>
#include <cstddef>

namespace linkdig::ig {
namespace {

/// A segment as the vectors make it: its fields in a word.
constexpr int first_shift = 16, count_shift = 32;
static_assert(std::endian::native == std::endian::little && sizeof(Segment) == sizeof(std::uint64_t) &&
              offsetof(Segment, line) == 0 && offsetof(Segment, first) == first_shift / 8 &&
              offsetof(Segment, count) == count_shift / 8);

/// Segments that one face can have in a band at the most, and room for a vector behind them.
constexpr std::size_t most_segments = std::size_t{band_lines} * max_raster_side / 2 + 8;

} // namespace
} // namespace linkdig::ig
#endif

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "ig/scanline/opaque_faces.cpp"
#include <hwy/foreach_target.h> // compiles this file once for every SIMD level
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace linkdig::ig {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

#if HWY_TARGET != HWY_SCALAR && HWY_TARGET != HWY_EMU128

using I64 = hn::CappedTag<std::int64_t, 8>;
using U64 = hn::Repartition<std::uint64_t, I64>;
using V = hn::Vec<I64>;
using W = hn::Vec<U64>;

// Vectors are handed over one by one: g++ 12 copies structures of them through memory.

/// The number, and those behind it. (Iota() of what is not a constant waits for its lanes to be written to memory.)
HWY_INLINE V From(std::int64_t number) { return hn::Add(hn::Iota(I64(), 0), hn::Set(I64(), number)); }

/// Where a face begins and ends on consecutive lines, as first_element(); where it has no line, both are nought. One loop over
/// the edges of both sides: which of a triangle's has two nobody can foretell.
HWY_INLINE void Cross(const EdgeFace& face, const Edge* edges, V lines, V& begin, V& end) {
    const I64 d;
    const Edge* const trailing = edges + face.leading;
    const Edge* const last = trailing + face.trailing;
    begin = end = hn::Zero(d);
    for (const Edge* edge = edges; edge != last; ++edge) {
        const auto steps = hn::Sub(lines, hn::Set(d, edge->first_line));
        const auto here = hn::Add(hn::Set(d, edge->start), hn::Mul(steps, hn::Set(d, edge->slope)));
        const auto reached =
            hn::And(hn::Gt(steps, hn::Set(d, -1)), hn::Lt(lines, hn::Set(d, edge->end_line)));
        const auto leading = hn::MaskFromVec(hn::Set(d, edge < trailing ? -1 : 0));
        begin = hn::IfThenElse(hn::And(reached, leading), here, begin);
        end = hn::IfThenElse(hn::AndNot(leading, reached), here, end);
    }
    begin = hn::ShiftRight<crossing_bits>(begin);
    end = hn::ShiftRight<crossing_bits>(end);
}

/// The bits of a word that stand at or behind `element`, the first of them being element `at`.
HWY_INLINE W BitsFrom(V element, V at) {
    const I64 d;
    const auto inside = hn::Min(hn::Max(hn::Sub(element, at), hn::Zero(d)), hn::Set(d, 64));
    return hn::Shl(hn::Set(U64(), ~std::uint64_t{0}), hn::BitCast(U64(), inside)); // by 64: nothing is left
}

HWY_INLINE bool Nothing(W bits) { return hn::AllTrue(U64(), hn::Eq(bits, hn::Zero(U64()))); }

/// The words that the mask names, one behind the other; what follows them is meaningless.
HWY_INLINE W Together(W words, hn::Mask<U64> which) {
#if HWY_TARGET <= HWY_AVX3 // Highway 1.0 does it by a table that g++ copies to the stack each time
    return W{_mm512_maskz_compress_epi64(which.raw, words.raw)};
#else
    return hn::Compress(words, which);
#endif
}

/// The lowest run of set bits of each word: its first bit, its length, and what is left without it. False in `inside` where there
/// is none, or where it ends with the word.
HWY_INLINE W LowestRun(W bits, W& first, W& count, hn::Mask<U64>& inside) {
    const U64 d;
    const auto lowest = hn::And(bits, hn::Sub(hn::Zero(d), bits));
    const auto carried = hn::Add(bits, lowest); // to the first clear bit behind the run; none: nought
    first = hn::PopulationCount(hn::Sub(lowest, hn::Set(d, 1)));
    inside = hn::Ne(carried, hn::Zero(d));
    const auto rest = hn::And(bits, carried);
    count = hn::PopulationCount(hn::Xor(bits, rest));
    return rest;
}

/// As many lines of the band as a vector has, while a face takes what is open of them.
class Lines {
public:
    HWY_INLINE Lines(OpenBand& band, std::size_t first, Segment* next)
        : open_(band.open.data()), first_(first), next_(next), taken_(hn::Zero(U64())), segments_(taken_),
          numbers_(hn::BitCast(U64(), From(band.first_line + static_cast<std::int64_t>(first)))) {}

    /// What is open of the window of 64 elements that begins at this one.
    HWY_INLINE W Window(std::uint32_t element) const {
        const U64 d;
        const std::uint64_t* const open = open_[element / word_bits].of_line.data() + first_;
        const auto here = hn::ShiftRightSame(hn::Load(d, open), static_cast<int>(element % word_bits));
        const auto next = hn::Load(d, open + band_lines);
        return hn::Or(here,
                      hn::ShiftLeft<1>(hn::ShiftLeftSame(next, static_cast<int>(63 - element % word_bits))));
    }

    /// Its elements that lie in a window, of which `before` is open.
    HWY_INLINE void TakeWindow(V begin, V end, std::uint32_t element, W before) {
        const U64 d;
        const auto at = hn::Set(I64(), element);
        W mine = hn::And(before, hn::AndNot(BitsFrom(end, at), BitsFrom(begin, at)));
        taken_ = hn::PopulationCount(mine);
        std::uint64_t* const open = open_[element / word_bits].of_line.data() + first_;
        const auto here = hn::ShiftLeftSame(mine, static_cast<int>(element % word_bits));
        const auto next =
            hn::ShiftRightSame(hn::ShiftRight<1>(mine), static_cast<int>(63 - element % word_bits));
        hn::Store(hn::Xor(hn::Load(d, open), here), d, open);
        hn::Store(hn::Xor(hn::Load(d, open + band_lines), next), d, open + band_lines);
        do {
            mine = PutLowest(mine, hn::BitCast(d, at));
        } while (!Nothing(mine));
    }

    /// Its elements of several words: a run that reaches the end of a word goes on in the next.
    HWY_INLINE void TakeWords(V begin, V end, std::size_t word, std::size_t last) {
        const U64 d;
        auto running = hn::MaskFromVec(hn::Zero(d));
        auto start = hn::Zero(d); // of what is running
        for (; word <= last; ++word) {
            W mine = Take(begin, end, word);
            if (hn::AllTrue(d, hn::Eq(mine, hn::VecFromMask(d, running))))
                continue; // all goes on, or nothing
            const auto at = hn::Set(d, word * word_bits);
            const auto all = hn::Eq(mine, hn::Set(d, ~std::uint64_t{0}));
            const auto more =
                hn::AndNot(hn::Add(mine, hn::Set(d, 1)), mine); // the lowest bits, if they are set
            const auto ends = hn::AndNot(all, running);
            Put(ends, start, hn::Sub(hn::Add(at, hn::PopulationCount(more)), start));
            mine = hn::IfThenElse(running, hn::AndNot(more, mine), mine);
            running = hn::And(running, all);
            while (!Nothing(mine)) {
                W first, count;
                hn::Mask<U64> inside;
                const auto there = hn::Ne(mine, hn::Zero(d));
                mine = LowestRun(mine, first, count, inside);
                first = hn::Add(at, first);
                Put(hn::And(inside, there), first, count);
                const auto goes_on = hn::AndNot(inside, there);
                start = hn::IfThenElse(goes_on, first, start);
                running = hn::Or(running, goes_on);
            }
        }
        Put(running, start, hn::Sub(hn::Set(d, word * word_bits), start));
    }

    /// Tells the band what has been taken; returns the end of the segments.
    HWY_INLINE Segment* Settle(OpenBand& band, std::size_t first, BandSegments& out) const {
        const U64 d;
        if (Nothing(taken_)) return next_;
        std::uint64_t* const count = band.count.data() + first;
        const auto left = hn::Sub(hn::Load(d, count), taken_);
        hn::Store(left, d, count);
        const auto closed = hn::And(hn::Eq(left, hn::Zero(d)), hn::Ne(taken_, hn::Zero(d)));
        band.open_lines -= static_cast<std::uint32_t>(hn::CountTrue(d, closed));
        std::uint64_t* const on_line = out.on_line.data() + first;
        hn::Store(hn::Add(hn::Load(d, on_line), segments_), d, on_line);
        return next_;
    }

private:
    /// Puts out the lowest run of each line; what is left without it.
    HWY_INLINE W PutLowest(W mine, W at) {
        W first, count;
        hn::Mask<U64> inside;
        const auto there = hn::Ne(mine, hn::Zero(U64()));
        const auto rest = LowestRun(mine, first, count, inside);
        Put(there, hn::Add(at, first), count);
        return rest;
    }

    HWY_INLINE W Take(V begin, V end, std::size_t word) {
        const U64 d;
        std::uint64_t* const open = open_[word].of_line.data() + first_;
        const auto at = hn::Set(I64(), static_cast<std::int64_t>(word * word_bits));
        const auto bits = hn::AndNot(BitsFrom(end, at), BitsFrom(begin, at));
        const auto before = hn::Load(d, open);
        const auto mine = hn::And(before, bits);
        hn::Store(hn::Xor(before, mine), d, open);
        taken_ = hn::Add(taken_, hn::PopulationCount(mine));
        return mine;
    }

    HWY_INLINE void Put(hn::Mask<U64> which, W first, W count) {
        const U64 d;
        const auto fields =
            hn::Or(hn::Or(numbers_, hn::ShiftLeft<first_shift>(first)), hn::ShiftLeft<count_shift>(count));
        hn::StoreU(Together(fields, which), d, reinterpret_cast<std::uint64_t*>(next_));
        next_ += hn::CountTrue(d, which);
        segments_ = hn::Sub(segments_, hn::VecFromMask(d, which)); // the mask is minus one
    }

    OpenWords* open_;
    std::size_t first_;
    Segment* next_;
    W taken_, segments_, numbers_;
};

/// Takes the lines of a face whose elements all lie in a window of 64; returns the end of its segments.
HWY_INLINE Segment* TakeNarrow(const EdgeFace& face, const Edge* edges, const LineRange& range,
                               OpenBand& band, BandSegments& out, Segment* next) {
    const I64 d;
    const auto element = static_cast<std::uint32_t>(face.first_element);
    const auto width = static_cast<std::uint32_t>(face.end_element) - element;
    const auto reach = hn::Set(U64(), ~std::uint64_t{0} >> (word_bits - width));
    for (std::size_t line = range.from; line < range.to; line += hn::Lanes(d)) {
        Lines lines(band, line, next);
        const auto before = hn::And(lines.Window(element), reach);
        if (Nothing(before)) continue;
        V begin, end;
        Cross(face, edges, From(band.first_line + static_cast<std::int64_t>(line)), begin, end);
        lines.TakeWindow(begin, end, element, before);
        next = lines.Settle(band, line, out);
    }
    return next;
}

/// The same of any face.
HWY_INLINE Segment* TakeWide(const EdgeFace& face, const Edge* edges, const LineRange& range, OpenBand& band,
                             BandSegments& out, Segment* next) {
    const I64 d;
    const auto word = static_cast<std::size_t>(face.first_element) / word_bits;
    const auto last = static_cast<std::size_t>(face.end_element - 1) / word_bits;
    for (std::size_t line = range.from; line < range.to; line += hn::Lanes(d)) {
        V begin, end;
        Cross(face, edges, From(band.first_line + static_cast<std::int64_t>(line)), begin, end);
        Lines lines(band, line, next);
        lines.TakeWords(begin, end, word, last);
        next = lines.Settle(band, line, out);
    }
    return next;
}

/// Takes the face's lines of the band, whole vectors of them; returns the end of its segments.
HWY_INLINE Segment* TakeFace(const EdgeFace& face, const Edge* edges, OpenBand& band, BandSegments& out,
                             Segment* next) {
    if (face.first_element >= face.end_element) return next;
    const std::size_t lanes = hn::Lanes(I64());
    const LineRange lines = band.lines_of(face);
    const LineRange range{lines.from / lanes * lanes, lines.to};
    return face.end_element - face.first_element <= static_cast<std::int32_t>(word_bits)
               ? TakeNarrow(face, edges, range, band, out, next)
               : TakeWide(face, edges, range, band, out, next);
}

std::size_t TakeOpaqueFaces(const FaceEdges& edges, std::span<const std::uint32_t> ranks, OpenBand& band,
                            BandSegments& out) {
    std::size_t made = out.segments.size();
    std::size_t faces = out.faces.size();
    out.faces.resize(faces + ranks.size());
    std::size_t k = 0;
    for (; k < ranks.size() && band.open_lines != 0; ++k) {
        fetch_ahead(edges, ranks.subspan(k), false);
        const EdgeFace& face = edges.faces[ranks[k]];
        if (face.blends) break;
        if (out.segments.size() < made + most_segments) out.segments.resize(2 * made + most_segments);
        const Segment* const end =
            TakeFace(face, edges.edges.data() + face.first_edge, band, out, out.segments.data() + made);
        const auto now = static_cast<std::size_t>(end - out.segments.data());
        out.faces[faces] = {ranks[k], static_cast<std::uint32_t>(now)}; // written over if it has none
        faces += now != made ? 1 : 0;
        made = now;
    }
    out.faces.resize(faces);
    out.segments.resize(made);
    return k;
}

#else

std::size_t TakeOpaqueFaces(const FaceEdges& /*edges*/, std::span<const std::uint32_t> /*ranks*/,
                            OpenBand& /*band*/, BandSegments& /*out*/) {
    return 0;
}

#endif

} // namespace HWY_NAMESPACE
} // namespace linkdig::ig
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace linkdig::ig {

namespace {

HWY_EXPORT(TakeOpaqueFaces);

} // namespace

std::size_t take_opaque_faces(const FaceEdges& edges, std::span<const std::uint32_t> ranks, OpenBand& band,
                              BandSegments& segments) {
    if (simd_is_off()) return 0;
    return HWY_DYNAMIC_DISPATCH(TakeOpaqueFaces)(edges, ranks, band, segments);
}

} // namespace linkdig::ig
#endif
