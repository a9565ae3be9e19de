#ifndef LINKDIG_EDGE_BATCH_ONCE
#define LINKDIG_EDGE_BATCH_ONCE
#include "ig/edges/edge_batch.h"

#include "ig/simd/simd_level.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstring>
#include <type_traits>

namespace linkdig::ig {
namespace {

/// Faces of a batch: few, so that memory is read and written in a steady stream (with 64 a frame's edges took 15 % longer).
constexpr std::size_t room = 16;
constexpr std::size_t most_corners = 4; ///< of a face in it
constexpr std::size_t most_lanes = 8;
constexpr std::size_t least_lanes = 4; ///< with two the plain way is as fast

template <typename T>
using Row = std::array<T, room>;

/// A record, or a part of one, as whole words, which is how vectors make it.
using Word = std::int64_t;
static_assert(std::endian::native == std::endian::little); // a record's first bytes are a word's lower ones
static_assert(offsetof(EdgeFace, leading) == 4 && offsetof(EdgeFace, trailing) == 6);
static_assert(offsetof(EdgeFace, blends) == 12 && offsetof(EdgeFace, additive) == 13);
static_assert(offsetof(EdgeFace, opacity) == 14 && offsetof(EdgeFace, fade) == 16);
static_assert(offsetof(EdgeFace, level) == 20 &&
              offsetof(EdgeFace, first_outline) == 24); // the elements follow
static_assert(offsetof(FaceShading, colour) == 28 && offsetof(FaceShading, coloured) == 30);

/// Beside the upper half of a FaceShading's last word, which stands in the lower: the face has no triangle.
constexpr Word flat_face = Word{1} << 32;

struct Batch {
    std::size_t count = 0;
    std::size_t corners = 3; ///< of the face that has most
    std::int32_t lines = 0;  ///< of the raster
    std::int32_t elements = 0;

    // Given: the corners, the first one again where there is no fourth; those of the triangle before it was clipped, of a flat
    // face one of no area; colour, and flat_face.
    alignas(64) std::array<Row<Word>, most_corners> corner;
    alignas(64) std::array<Row<double>, 3> triangle_line, triangle_element;
    alignas(64) std::array<Row<std::int32_t>, 3> intensity;
    alignas(64) Row<Word> colour;

    // Made: of each corner the place as numbers, and the first line whose centre is at or below it; words of an edge, and its
    // place among the face's; the first two words of an EdgeFace, in part.
    alignas(64) std::array<Row<double>, most_corners> line, element, centre;
    alignas(64) std::array<Row<Word>, most_corners> edge_lines, start, slope, place;
    alignas(64) Row<Word> edges; ///< how many
    alignas(64) Row<Word> sides, face_lines, face_elements;
    alignas(64) Row<std::array<Word, 4>> shading;
};

} // namespace
} // namespace linkdig::ig
#endif

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "ig/edges/edge_batch.cpp"
#include <hwy/foreach_target.h> // compiles this file once for every SIMD level
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace linkdig::ig {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using F64 = hn::CappedTag<double, most_lanes>;
using I64 = hn::Repartition<std::int64_t, F64>;
using I32 = hn::Rebind<std::int32_t, F64>;
using V = hn::Vec<F64>;
using N = hn::Vec<I64>;
using M = hn::Mask<F64>;

// ---- in -------------------------------------------------------------------------------------------------------------

HWY_INLINE bool Fits(const ProjectedFace& face) {
    return (face.point_count == 3 || face.point_count == most_corners) && face.colour_step == 0;
}

HWY_INLINE void PutTriangle(const IntensityTriangle& triangle, std::size_t at, Batch& batch) {
    for (std::size_t k = 0; k < 3; ++k) {
        batch.triangle_line[k][at] = triangle.line[k];
        batch.triangle_element[k][at] = triangle.element[k];
        batch.intensity[k][at] = triangle.intensity[k];
    }
}

HWY_INLINE void PutFace(const ProjectedFaces& projected, const ProjectedFace& face, std::size_t at,
                        Batch& batch) {
    const RasterPoint* const points = projected.points.data() + face.first_point;
    for (std::size_t k = 0; k < 3; ++k)
        batch.corner[k][at] = std::bit_cast<Word>(points[k]);
    batch.corner[3][at] = std::bit_cast<Word>(points[face.point_count == most_corners ? 3 : 0]);
    batch.corners = std::max<std::size_t>(batch.corners, face.point_count);
    const Word colour = face.colour;
    if (face.triangle >= 0) {
        batch.colour[at] = colour;
        PutTriangle(projected.triangles[static_cast<std::size_t>(face.triangle)], at, batch);
    } else {
        batch.colour[at] = colour | flat_face;
        PutTriangle({.intensity = {face.intensity, face.intensity, face.intensity}}, at, batch);
    }
}

/// Takes faces from `rank` on, as many as fit. The last is repeated to the end of a vector, so that every lane has numbers.
HWY_INLINE void Fill(const ProjectedFaces& projected, std::size_t rank, Batch& batch) {
    const ProjectedFace* const faces = projected.faces.data() + rank;
    const std::size_t most = std::min(room, projected.faces.size() - rank);
    while (batch.count < most && Fits(faces[batch.count]))
        ++batch.count;
    const std::size_t lanes = batch.count + (most_lanes - batch.count % most_lanes) % most_lanes;
    for (std::size_t k = 0; k < lanes; ++k)
        PutFace(projected, faces[std::min(k, batch.count - 1)], k, batch);
}

// ---- out ------------------------------------------------------------------------------------------------------------

/// Word by word: a record put together first, and then copied, waits until its parts have arrived in memory.
template <typename Record, typename... Each>
HWY_INLINE void Put(Record& record, Each... words) {
    static_assert(std::is_trivially_copyable_v<Record> && sizeof(Record) == sizeof...(words) * sizeof(Word));
    auto* place = reinterpret_cast<std::byte*>(&record);
    ((std::memcpy(place, &words, sizeof(Word)), place += sizeof(Word)), ...);
}

/// As face_without_edges(), and with what the batch knows.
HWY_INLINE void WriteFace(const Batch& batch, std::size_t k, const ProjectedFace& face,
                          std::size_t edges_made, EdgeFace& made) {
    const bool additive = face.added_to >= 0;
    Put(made, batch.sides[k] | static_cast<Word>(static_cast<std::uint32_t>(edges_made)),
        batch.face_lines[k] | Word{blends(face)} << 32 | Word{additive} << 40 | Word{face.opacity} << 48,
        Word{face.fade} | Word{face.level} << 32, batch.face_elements[k]);
}

/// Without a branch on which side an edge is, or whether there is one: what is none is written behind the last, where the
/// next face's come.
HWY_INLINE void WriteEdges(const Batch& batch, std::size_t k, Edge* edges) {
    for (std::size_t side = 0; side < batch.corners; ++side)
        Put(edges[batch.place[side][k]], batch.edge_lines[side][k], batch.start[side][k],
            batch.slope[side][k]);
}

HWY_INLINE void Write(const ProjectedFaces& projected, std::size_t rank, const Batch& batch, FaceEdges& out,
                      std::size_t& edges_made) {
    Edge* edges = room_for_edges(out, edges_made, room * most_corners + 1);
    const Edge* const first = edges - edges_made;
    const ProjectedFace* const faces = projected.faces.data() + rank;
    EdgeFace* const made = out.faces.data() + rank;
    FaceShading* const shadings = out.shadings.data() + rank;
    for (std::size_t k = 0; k < batch.count; ++k) {
        WriteFace(batch, k, faces[k], static_cast<std::size_t>(edges - first), made[k]);
        std::memcpy(static_cast<void*>(shadings + k), &batch.shading[k], sizeof(FaceShading));
        WriteEdges(batch, k, edges);
        edges += batch.edges[k];
    }
    edges_made = static_cast<std::size_t>(edges - first);
}

// ---- between --------------------------------------------------------------------------------------------------------

HWY_INLINE V Set(double value) { return hn::Set(F64(), value); }
HWY_INLINE N Set(Word value) { return hn::Set(I64(), value); }
HWY_INLINE V Load(const Row<std::int32_t>& row, std::size_t k) {
    return hn::PromoteTo(F64(), hn::Load(I32(), row.data() + k));
}
HWY_INLINE V Load(const Row<double>& row, std::size_t k) { return hn::Load(F64(), row.data() + k); }
HWY_INLINE N Load(const Row<Word>& row, std::size_t k) { return hn::Load(I64(), row.data() + k); }
HWY_INLINE void Store(N value, Row<Word>& row, std::size_t k) { hn::Store(value, I64(), row.data() + k); }

/// Numbers under 2^51 from one type to the other, to the nearest whole one: added to this they stand in the fraction's last bits.
constexpr double whole_at = 6755399441055744.0; // 3 * 2^51
HWY_INLINE N WholeOf(V whole) {
    return hn::Sub(hn::BitCast(I64(), hn::Add(whole, Set(whole_at))), hn::BitCast(I64(), Set(whole_at)));
}
HWY_INLINE V DoubleOf(N whole) {
    const N bits = hn::Add(whole, hn::BitCast(I64(), Set(whole_at)));
    return hn::Sub(hn::BitCast(F64(), bits), Set(whole_at));
}

HWY_INLINE void Store(V value, Row<double>& row, std::size_t k) { hn::Store(value, F64(), row.data() + k); }

/// The lower half of a word below that of another.
HWY_INLINE N Joined(N lower, N upper) {
    return hn::Or(hn::And(lower, Set(Word{0xffffffff})), hn::ShiftLeft<32>(upper));
}
HWY_INLINE N Joined(V lower, V upper) { return WholeOf(hn::Add(lower, hn::Mul(upper, Set(4294967296.0)))); }

/// 1 where true, else 0.
HWY_INLINE N Count(M where) { return hn::IfThenElseZero(hn::RebindMask(I64(), where), Set(Word{1})); }

/// base + dividend / divisor in units of 2^-40, rounded down, modulo 2^64: the same numbers as fixed_quotient()'s, by one division
/// for several dividends. |dividend| < 2^49, 0 < divisor < 2^25, all whole numbers. A product with the reciprocal is off by an
/// eighth at the most, so the nearest whole number leaves a rest under a divisor, either way. The nearest fraction to the rest is
/// off by hardly more than a half: it is the one sought, or the one above, which what is left tells.
struct Divisor {
    V value;
    N whole_value;
    V reciprocal;
    V scaled; ///< reciprocal, in units of 2^-40

    HWY_INLINE explicit Divisor(V divisor)
        : value(divisor), whole_value(WholeOf(divisor)), reciprocal(hn::Div(Set(1.0), divisor)),
          scaled(hn::Mul(reciprocal, Set(static_cast<double>(std::int64_t{1} << fraction_bits)))) {}

    HWY_INLINE N Quotient(V base, V dividend) const {
        const V near = hn::Add(hn::Mul(dividend, reciprocal), Set(whole_at)); // as WholeOf()
        const V rest = hn::Sub(dividend, hn::Mul(hn::Sub(near, Set(whole_at)), value));
        const N fraction = WholeOf(hn::Mul(rest, scaled));
        const N left = hn::Sub(hn::ShiftLeft<fraction_bits>(WholeOf(rest)), hn::Mul(fraction, whole_value));
        const N whole = hn::Sub(hn::BitCast(I64(), hn::Add(near, base)), hn::BitCast(I64(), Set(whole_at)));
        return hn::Add(hn::Add(hn::ShiftLeft<fraction_bits>(whole), fraction), hn::ShiftRight<63>(left));
    }
};

/// The corners of faces [k, k + lanes) as numbers.
HWY_INLINE void PlaceCorner(Batch& batch, std::size_t k, std::size_t corner) {
    const N point = Load(batch.corner[corner], k);
    const V line = DoubleOf(hn::ShiftRight<32>(hn::ShiftLeft<32>(point)));
    Store(line, batch.line[corner], k);
    Store(DoubleOf(hn::ShiftRight<32>(point)), batch.element[corner], k);
    // As first_line_at().
    Store(hn::Floor(hn::Mul(hn::Add(line, Set(127.0)), Set(1.0 / 256.0))), batch.centre[corner], k);
}

/// The pixel that a coordinate lies in.
HWY_INLINE V PixelAt(V coordinate) { return hn::Floor(hn::Mul(coordinate, Set(1.0 / 256.0))); }

/// The edges of some faces so far.
struct Sides {
    V first_line, end_line;
    V element;           ///< where the last leading edge that begins on the first line crosses it
    N leading, trailing; ///< how many
};

/// A number for a trailing edge, until it is known how many edges lead, and one for an edge that is none.
constexpr std::int64_t trailing_place = -8, no_place = 8;

/// Side `side` of faces [k, k + lanes).
HWY_INLINE void MakeSide(Batch& batch, std::size_t k, std::size_t side, Sides& sides) {
    const std::size_t next = side + 1 == batch.corners ? 0 : side + 1;
    const V from = Load(batch.line[side], k), to = Load(batch.line[next], k);
    const V from_element = Load(batch.element[side], k), to_element = Load(batch.element[next], k);
    const V from_centre = Load(batch.centre[side], k), to_centre = Load(batch.centre[next], k);
    const M leads = hn::Lt(to, from);
    const V upper = hn::Min(from, to), lower = hn::Max(from, to);
    const V upper_element = hn::IfThenElse(leads, to_element, from_element);
    const V lower_element = hn::IfThenElse(leads, from_element, to_element);
    const V first_line = hn::Max(hn::Min(from_centre, to_centre), Set(0.0));
    const V end_line = hn::Min(hn::Max(from_centre, to_centre), Set(static_cast<double>(batch.lines)));
    const M there = hn::Lt(first_line, end_line);

    const Divisor height(hn::Max(hn::Sub(lower, upper), Set(1.0))); // of one that is not there
    const V width = hn::Sub(lower_element, upper_element);
    const V down = hn::Sub(hn::Add(hn::Mul(first_line, Set(256.0)), Set(128.0)), upper);
    const N start =
        hn::Add(height.Quotient(upper_element, hn::Mul(down, width)), Set(Word{crossing_to_start}));
    const N slope = height.Quotient(Set(0.0), hn::Mul(width, Set(256.0)));
    const M several = hn::Gt(hn::Sub(end_line, first_line), Set(1.0));
    Store(Joined(first_line, end_line), batch.edge_lines[side], k);
    Store(start, batch.start[side], k);
    Store(hn::IfThenElseZero(hn::RebindMask(I64(), several), slope), batch.slope[side], k);

    const M leading = hn::And(there, leads);
    const N place = hn::IfThenElse(hn::RebindMask(I64(), leads), sides.leading,
                                   hn::Add(sides.trailing, Set(trailing_place)));
    Store(hn::IfThenElse(hn::RebindMask(I64(), there), place, Set(no_place)), batch.place[side], k);
    sides.leading = hn::Add(sides.leading, Count(leading));
    sides.trailing = hn::Add(sides.trailing, Count(hn::AndNot(leads, there)));
    // A closed outline crosses its first line upwards, too: one of the leading edges begins there.
    const M reference = hn::And(leading, hn::Le(first_line, sides.first_line));
    sides.element = hn::IfThenElse(reference, DoubleOf(hn::ShiftRight<crossing_bits>(start)), sides.element);
    sides.first_line = hn::IfThenElse(there, hn::Min(sides.first_line, first_line), sides.first_line);
    sides.end_line = hn::IfThenElse(there, hn::Max(sides.end_line, end_line), sides.end_line);
}

/// The places of trailing edges, now that it is known how many lead; of those that are none, behind the last.
HWY_INLINE void PlaceEdges(Batch& batch, std::size_t k, N leading, N edges) {
    const N behind_leading = hn::Sub(leading, Set(trailing_place));
    for (std::size_t side = 0; side < batch.corners; ++side) {
        const N place = Load(batch.place[side], k);
        const N behind = hn::IfThenElseZero(hn::Lt(place, hn::Zero(I64())), behind_leading);
        Store(hn::Min(hn::Add(place, behind), edges), batch.place[side], k);
    }
}

/// A value of an intensity plane modulo 2^32, in the lower half; as to_plane_units().
HWY_INLINE N ToPlaneUnits(V value) {
    const V bounded = hn::Min(hn::Max(value, Set(-plane_bound)), Set(plane_bound));
    const V whole = hn::Floor(hn::Add(bounded, Set(0.5)));
    const V wraps = hn::Floor(hn::Mul(whole, Set(1.0 / 4294967296.0)));
    return WholeOf(hn::Sub(whole, hn::Mul(wraps, Set(4294967296.0))));
}

/// As make_plane(); of a flat face as level_shading().
HWY_INLINE void MakeShading(Batch& batch, std::size_t k, V line, V element) {
    const V line_0 = Load(batch.triangle_line[0], k), element_0 = Load(batch.triangle_element[0], k);
    const V i_0 = Load(batch.intensity[0], k), i_1 = Load(batch.intensity[1], k),
            i_2 = Load(batch.intensity[2], k);
    const V e1 = hn::Sub(Load(batch.triangle_element[1], k), element_0);
    const V e2 = hn::Sub(Load(batch.triangle_element[2], k), element_0);
    const V l1 = hn::Sub(Load(batch.triangle_line[1], k), line_0);
    const V l2 = hn::Sub(Load(batch.triangle_line[2], k), line_0);
    const V i1 = hn::Sub(i_1, i_0), i2 = hn::Sub(i_2, i_0);
    const V area = hn::Sub(hn::Mul(e1, l2), hn::Mul(e2, l1));
    const M slopes = hn::Ne(area, Set(0.0));
    const V divisor = hn::IfThenElse(slopes, area, Set(1.0));
    const V along_by_area = hn::Sub(hn::Mul(i1, l2), hn::Mul(i2, l1));
    const V across_by_area = hn::Sub(hn::Mul(e1, i2), hn::Mul(e2, i1));
    const V along = hn::IfThenElseZero(slopes, hn::Div(along_by_area, divisor));
    const V across = hn::IfThenElseZero(slopes, hn::Div(across_by_area, divisor));
    const V from_corner_e = hn::Sub(hn::Add(hn::Mul(element, Set(256.0)), Set(128.0)), element_0);
    const V from_corner_l = hn::Sub(hn::Add(hn::Mul(line, Set(256.0)), Set(128.0)), line_0);
    const V value = hn::Add(hn::Add(i_0, hn::Mul(along, from_corner_e)), hn::Mul(across, from_corner_l));

    const N least = WholeOf(hn::Min(i_0, hn::Min(i_1, i_2)));
    const N greatest = WholeOf(hn::Max(i_0, hn::Max(i_1, i_2)));
    const N colour = Load(batch.colour, k);
    const auto smooth = hn::Lt(colour, Set(flat_face));
    const N reference = hn::IfThenElseZero(smooth, Joined(line, element));
    hn::StoreInterleaved4(reference, Joined(ToPlaneUnits(value), ToPlaneUnits(hn::Mul(along, Set(256.0)))),
                          Joined(ToPlaneUnits(hn::Mul(across, Set(256.0))), least), Joined(greatest, colour),
                          I64(), batch.shading[k].data());
}

/// As put_extent(): the elements that the corners stand in and all between, the word that holds them in its upper half.
HWY_INLINE N ExtentOf(const Batch& batch, std::size_t k) {
    V leftmost = Load(batch.element[0], k), rightmost = leftmost;
    for (std::size_t corner = 1; corner < batch.corners; ++corner) {
        leftmost = hn::Min(leftmost, Load(batch.element[corner], k));
        rightmost = hn::Max(rightmost, Load(batch.element[corner], k));
    }
    const V zero = Set(0.0), elements = Set(static_cast<double>(batch.elements));
    const V first = hn::Min(hn::Max(PixelAt(leftmost), zero), elements);
    const V end = hn::Min(hn::Max(hn::Add(PixelAt(rightmost), Set(1.0)), zero), elements);
    return hn::ShiftLeft<32>(WholeOf(hn::Add(first, hn::Mul(end, Set(65536.0)))));
}

/// Faces [k, k + lanes).
HWY_INLINE void MakeFaces(Batch& batch, std::size_t k) {
    const V lines = Set(static_cast<double>(batch.lines)), zero = Set(0.0);
    Sides sides{lines, zero, zero, hn::Zero(I64()), hn::Zero(I64())};
    for (std::size_t corner = 0; corner < batch.corners; ++corner)
        PlaceCorner(batch, k, corner);
    for (std::size_t side = 0; side < batch.corners; ++side)
        MakeSide(batch, k, side, sides);
    const N edges = hn::Add(sides.leading, sides.trailing);
    PlaceEdges(batch, k, sides.leading, edges);
    Store(edges, batch.edges, k);
    Store(hn::Or(hn::ShiftLeft<32>(sides.leading), hn::ShiftLeft<48>(sides.trailing)), batch.sides, k);
    Store(WholeOf(hn::Add(sides.first_line, hn::Mul(sides.end_line, Set(65536.0)))), batch.face_lines, k);
    Store(ExtentOf(batch, k), batch.face_elements, k);

    // The plane's reference is a pixel of the face; without an edge that leads, one that its first corner is in, or the nearest.
    const M none = hn::RebindMask(F64(), hn::Eq(sides.leading, hn::Zero(I64())));
    const V line = hn::IfThenElse(none, PixelAt(Load(batch.line[0], k)), sides.first_line);
    const V element = hn::IfThenElse(none, PixelAt(Load(batch.element[0], k)), sides.element);
    const V one = Set(1.0), elements = Set(static_cast<double>(batch.elements));
    MakeShading(batch, k, hn::Min(hn::Max(line, zero), hn::Sub(lines, one)),
                hn::Min(hn::Max(element, zero), hn::Sub(elements, one)));
}

std::size_t MakeEdgesTogether(const ProjectedFaces& projected, std::size_t rank, Batch& batch, FaceEdges& out,
                              std::size_t& edges_made) {
    if (hn::Lanes(F64()) < least_lanes) return 0;
    Fill(projected, rank, batch);
    for (std::size_t k = 0; k < batch.count; k += hn::Lanes(F64()))
        MakeFaces(batch, k);
    if (batch.count > 0) Write(projected, rank, batch, out, edges_made);
    return batch.count;
}

} // namespace HWY_NAMESPACE
} // namespace linkdig::ig
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace linkdig::ig {

namespace {

HWY_EXPORT(MakeEdgesTogether);

} // namespace

std::size_t make_edges_together(const ProjectedFaces& projected, std::size_t rank, std::int32_t lines,
                                std::int32_t elements, FaceEdges& out, std::size_t& edges_made) {
    if (simd_is_off()) return 0;
    Batch batch;
    batch.lines = lines;
    batch.elements = elements;
    return HWY_DYNAMIC_DISPATCH(MakeEdgesTogether)(projected, rank, batch, out, edges_made);
}

} // namespace linkdig::ig
#endif
