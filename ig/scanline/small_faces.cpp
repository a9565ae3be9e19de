#ifndef LINKDIG_SMALL_FACES_ONCE
#define LINKDIG_SMALL_FACES_ONCE
#include "ig/scanline/small_faces.h"

#include "ig/scanline/fetch_ahead.h"
#include "ig/scanline/open_mask.h"
#include "ig/simd/simd_level.h"

#include <algorithm>

namespace linkdig::ig {
namespace {

/// Crossings of one face with the band's lines, in elements; room for a vector behind the last line.
struct Crossings {
    static constexpr std::size_t room = band_lines + lines_behind;
    alignas(64) std::array<std::int64_t, room> begin;
    alignas(64) std::array<std::int64_t, room> end;
};

} // namespace
} // namespace linkdig::ig
#endif

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "ig/scanline/small_faces.cpp"
#include <hwy/foreach_target.h> // compiles this file once for every SIMD level
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace linkdig::ig {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

#if HWY_TARGET != HWY_SCALAR

using I64 = hn::CappedTag<std::int64_t, 8>;
using U64 = hn::Repartition<std::uint64_t, I64>;

/// Fills the crossings of the band's lines [from, to), as first_element(), within the raster; true if the face fits the
/// window on all of them. One loop for both sides: which of a triangle's has two edges nobody can foretell.
HWY_INLINE bool Cross(const EdgeFace& face, const Edge* edges, const OpenBand& band, std::size_t from,
                      std::size_t to, Crossings& crossings) {
    const I64 d;
    const auto none_before = hn::Set(d, -1);
    const auto elements = hn::Set(d, band.elements);
    const Edge* const trailing = edges + face.leading;
    const Edge* const last = trailing + face.trailing;
    auto wide = hn::Zero(d);
    for (std::size_t line = from; line < to; line += hn::Lanes(d)) {
        const auto lines = hn::Iota(d, band.first_line + static_cast<std::int32_t>(line));
        auto begin = hn::Zero(d);
        auto end = hn::Zero(d);
        for (const Edge* edge = edges; edge != last; ++edge) {
            const auto steps = hn::Sub(lines, hn::Set(d, edge->first_line));
            const auto here = hn::Add(hn::Set(d, edge->start), hn::Mul(steps, hn::Set(d, edge->slope)));
            const auto reached =
                hn::And(hn::Gt(steps, none_before), hn::Lt(lines, hn::Set(d, edge->end_line)));
            const auto leading = hn::MaskFromVec(hn::Set(d, edge < trailing ? -1 : 0));
            begin = hn::IfThenElse(hn::And(reached, leading), here, begin);
            end = hn::IfThenElse(hn::AndNot(leading, reached), here, end);
        }
        begin = hn::Min(hn::Max(hn::ShiftRight<crossing_bits>(begin), hn::Zero(d)), elements);
        end = hn::Min(hn::Max(hn::ShiftRight<crossing_bits>(end), hn::Zero(d)), elements);
        hn::StoreU(begin, d, crossings.begin.data() + line);
        hn::StoreU(end, d, crossings.end.data() + line);
        const auto reach = hn::Sub(end, hn::AndNot(hn::Set(d, 7), begin));
        const auto beyond = hn::And(hn::Gt(reach, hn::Set(d, 63)), hn::FirstN(d, to - line));
        wide = hn::Or(wide, hn::VecFromMask(d, beyond));
    }
    return hn::AllTrue(d, hn::Eq(wide, hn::Zero(d)));
}

/// Segments of one line whose elements are several runs, or one. Returns how many.
HWY_INLINE std::size_t PutRuns(std::uint64_t mine, Segment segment, std::uint32_t window, Segment* out) {
    std::size_t runs = 0;
    while (mine != 0) {
        const BitRun run = take_run(mine);
        segment.first = static_cast<std::uint16_t>(window + run.first);
        segment.count = static_cast<std::uint16_t>(run.count());
        out[runs++] = segment;
    }
    return runs;
}

/// Takes lines [from, to), as many as a vector has at the most; returns the end of the segments.
HWY_INLINE Segment* TakeLines(const Crossings& crossings, std::size_t from, std::size_t to,
                              std::uint32_t rank, OpenBand& band, Segment* out) {
    const I64 d;
    const U64 du;
    const std::size_t lanes = hn::Lanes(d);
    const auto begin = hn::LoadU(d, crossings.begin.data() + from);
    const auto end = hn::LoadU(d, crossings.end.data() + from);
    const auto some = hn::And(hn::Lt(begin, end), hn::FirstN(d, to - from));
    const auto first = hn::IfThenElseZero(some, begin);
    const auto width = hn::BitCast(du, hn::IfThenElseZero(some, hn::Sub(end, begin)));
    const auto one = hn::Set(du, 1);
    const auto byte = hn::ShiftRight<3>(first);
    const auto bits =
        hn::Shl(hn::Sub(hn::Shl(one, width), one), hn::BitCast(du, hn::And(first, hn::Set(d, 7))));
    const auto line_bytes = static_cast<std::int64_t>(8 * band.stride);
    const auto offset = hn::Add(hn::Mul(hn::Iota(d, 0), hn::Set(d, line_bytes)), byte);
    std::uint64_t* const open = band.open.data() + from * band.stride;
    const auto before = hn::GatherOffset(du, open, offset);
    const auto mine = hn::And(before, bits);
    if (hn::AllTrue(du, hn::Eq(mine, hn::Zero(du)))) return out;
    hn::ScatterOffset(hn::Xor(before, mine), du, open, offset);

    const auto taken = hn::PopulationCount(mine);
    const auto left = hn::Sub(hn::LoadU(du, band.count.data() + from), taken);
    hn::BlendedStore(left, hn::FirstN(du, to - from), du, band.count.data() + from);
    const auto closed = hn::And(hn::Eq(left, hn::Zero(du)), hn::Ne(taken, hn::Zero(du)));
    band.open_lines -= static_cast<std::uint32_t>(hn::CountTrue(du, closed));

    alignas(64) std::array<std::uint64_t, 8> elements, windows, counts, starts; // of which `lanes` are used
    hn::Store(mine, du, elements.data());
    hn::Store(hn::BitCast(du, hn::ShiftLeft<3>(byte)), du, windows.data());
    const auto lowest = hn::And(mine, hn::Sub(hn::Zero(du), mine));
    const auto several = hn::And(mine, hn::Add(mine, lowest)); // bits behind the first run
    const auto line_of = [&](std::size_t lane) {
        return static_cast<std::uint16_t>(band.first_line + static_cast<std::int32_t>(from + lane));
    };
    if (!hn::AllTrue(du, hn::Eq(several, hn::Zero(du)))) {
        for (std::size_t lane = 0; lane < lanes; ++lane)
            out += PutRuns(elements[lane], {.face = rank, .line = line_of(lane)},
                           static_cast<std::uint32_t>(windows[lane]), out);
        return out;
    }
    hn::Store(hn::Add(hn::Load(du, windows.data()), hn::PopulationCount(hn::Sub(lowest, one))), du,
              starts.data());
    hn::Store(taken, du, counts.data());
    for (std::size_t lane = 0; lane < lanes;
         ++lane) { // without a branch: a line without elements is written over
        *out = {.face = rank,
                .line = line_of(lane),
                .first = static_cast<std::uint16_t>(starts[lane]),
                .count = static_cast<std::uint16_t>(counts[lane])};
        out += std::min<std::uint64_t>(counts[lane], 1);
    }
    return out;
}

/// Segments that one face can have in a band at the most, and one to be written over.
constexpr std::size_t most_segments = std::size_t{band_lines} * 32 + 1;

std::size_t TakeSmallFaces(const FaceEdges& edges, std::span<const std::uint32_t> ranks, OpenBand& band,
                           SegmentList& segments) {
    Crossings crossings;
    const std::size_t lanes = hn::Lanes(I64());
    std::size_t made = segments.size();
    std::size_t k = 0;
    for (; k < ranks.size() && band.open_lines != 0; ++k) {
        fetch_ahead(edges, ranks.subspan(k), false);
        const EdgeFace& face = edges.faces[ranks[k]];
        if (face.blends) break;
        const Edge* edge = edges.edges.data() + face.first_edge;
        const auto from =
            static_cast<std::size_t>(std::max(face.first_line, band.first_line) - band.first_line);
        const auto to = static_cast<std::size_t>(std::min(face.end_line, band.end_line) - band.first_line);
        if (!Cross(face, edge, band, from, to, crossings)) break;
        if (segments.size() < made + most_segments) segments.resize(2 * made + most_segments);
        Segment* out = segments.data() + made;
        for (std::size_t line = from; line < to; line += lanes)
            out = TakeLines(crossings, line, to, ranks[k], band, out);
        made = static_cast<std::size_t>(out - segments.data());
    }
    segments.resize(made);
    return k;
}

#else

std::size_t TakeSmallFaces(const FaceEdges& /*edges*/, std::span<const std::uint32_t> /*ranks*/,
                           OpenBand& /*band*/, SegmentList& /*segments*/) {
    return 0;
}

#endif

} // namespace HWY_NAMESPACE
} // namespace linkdig::ig
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace linkdig::ig {

namespace {

HWY_EXPORT(TakeSmallFaces);

} // namespace

std::size_t take_small_faces(const FaceEdges& edges, std::span<const std::uint32_t> ranks, OpenBand& band,
                             SegmentList& segments) {
    if (simd_is_off()) return 0;
    return HWY_DYNAMIC_DISPATCH(TakeSmallFaces)(edges, ranks, band, segments);
}

} // namespace linkdig::ig
#endif
