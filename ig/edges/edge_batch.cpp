#ifndef LINKDIG_EDGE_BATCH_ONCE
#define LINKDIG_EDGE_BATCH_ONCE
#include "ig/edges/edge_batch.h"

#include "ig/simd/simd_level.h"

#include <algorithm>
#include <array>

namespace linkdig::ig {
namespace {

constexpr std::size_t room = 64;        ///< faces of a batch
constexpr std::size_t most_corners = 4; ///< of a face in it
constexpr std::size_t most_lanes = 8;

template <typename T>
using Row = std::array<T, room>;

struct Batch {
    std::size_t count = 0;
    std::size_t corners = 3; ///< of the face that has most
    std::int32_t lines = 0;  ///< of the raster
    std::int32_t elements = 0;

    // Given: the corners, the first one again where there is no fourth, and those of the triangle before it was clipped; of a
    // flat face a triangle of no area.
    alignas(64) std::array<Row<std::int32_t>, most_corners> line, element;
    alignas(64) std::array<Row<double>, 3> triangle_line, triangle_element;
    alignas(64) std::array<Row<std::int32_t>, 3> intensity;

    // Made: per edge, in the order of the corners, and its place among the face's; per face.
    alignas(64) std::array<Row<std::int32_t>, most_corners> edge_first_line, edge_end_line;
    alignas(64) std::array<Row<std::int64_t>, most_corners> start, slope, place;
    alignas(64) Row<std::int64_t> leading, edges;
    alignas(64) Row<std::int32_t> first_line, end_line;
    alignas(64) Row<std::int32_t> reference_element, least, greatest;
    alignas(64) Row<std::int64_t> value, along, across; ///< of which the lower 32 bits
};

bool fits(const ProjectedFace& face) { return face.point_count <= most_corners && face.colour_step == 0; }

void put_triangle(const IntensityTriangle& triangle, std::size_t at, Batch& batch) {
    for (std::size_t k = 0; k < 3; ++k) {
        batch.triangle_line[k][at] = triangle.line[k];
        batch.triangle_element[k][at] = triangle.element[k];
        batch.intensity[k][at] = triangle.intensity[k];
    }
}

void put_face(const ProjectedFaces& projected, const ProjectedFace& face, std::size_t at, Batch& batch) {
    const RasterPoint* const points = projected.points.data() + face.first_point;
    for (std::size_t k = 0; k < most_corners; ++k) {
        const RasterPoint& point = points[k < face.point_count ? k : 0];
        batch.line[k][at] = point.line;
        batch.element[k][at] = point.element;
    }
    batch.corners = std::max<std::size_t>(batch.corners, face.point_count);
    if (face.triangle >= 0)
        put_triangle(projected.triangles[static_cast<std::size_t>(face.triangle)], at, batch);
    else
        put_triangle({.intensity = {face.intensity, face.intensity, face.intensity}}, at, batch);
}

/// Takes faces from `rank` on, as many as fit. The last is repeated to the end of a vector, so that every lane has numbers.
void fill(const ProjectedFaces& projected, std::size_t rank, Batch& batch) {
    const std::size_t end = std::min(rank + room, projected.faces.size());
    for (; rank < end && fits(projected.faces[rank]); ++rank)
        put_face(projected, projected.faces[rank], batch.count++, batch);
    if (batch.count == 0) return;
    for (std::size_t k = batch.count; k % most_lanes != 0; ++k)
        put_face(projected, projected.faces[rank - 1], k, batch);
}

void write_shading(const Batch& batch, std::size_t k, const ProjectedFace& face, FaceShading& shading) {
    if (face.triangle < 0 || batch.leading[k] == 0) {
        shading = level_shading(face);
        return;
    }
    shading = {.plane = {.reference_line = batch.first_line[k],
                         .reference_element = batch.reference_element[k],
                         .value = static_cast<std::uint32_t>(batch.value[k]),
                         .along = static_cast<std::uint32_t>(batch.along[k]),
                         .across = static_cast<std::uint32_t>(batch.across[k]),
                         .least = batch.least[k],
                         .greatest = batch.greatest[k]},
               .colour = face.colour,
               .through_air = face.depth >= 0};
}

/// Without a branch on which side an edge is, or whether there is one: what is none is written behind the last, where the
/// next face's come.
void write_edges(const Batch& batch, std::size_t k, Edge* edges) {
    for (std::size_t side = 0; side < batch.corners; ++side)
        edges[batch.place[side][k]] = {.first_line = batch.edge_first_line[side][k],
                                       .end_line = batch.edge_end_line[side][k],
                                       .start = batch.start[side][k],
                                       .slope = batch.slope[side][k]};
}

void write(const ProjectedFaces& projected, std::size_t rank, const Batch& batch, FaceEdges& out,
           std::size_t& edges_made) {
    Edge* const edges = room_for_edges(out, edges_made, room * most_corners + 1) - edges_made;
    for (std::size_t k = 0; k < batch.count; ++k) {
        const ProjectedFace& face = projected.faces[rank + k];
        EdgeFace made = face_without_edges(face, edges_made, 0);
        made.leading = static_cast<std::uint16_t>(batch.leading[k]);
        made.trailing = static_cast<std::uint16_t>(batch.edges[k] - batch.leading[k]);
        made.first_line = batch.first_line[k];
        made.end_line = batch.end_line[k];
        out.faces[rank + k] = made;
        write_shading(batch, k, face, out.shadings[rank + k]);
        write_edges(batch, k, edges + edges_made);
        edges_made += static_cast<std::size_t>(batch.edges[k]);
    }
}

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

HWY_INLINE V Set(double value) { return hn::Set(F64(), value); }
HWY_INLINE V Load(const Row<std::int32_t>& row, std::size_t k) {
    return hn::PromoteTo(F64(), hn::Load(I32(), row.data() + k));
}
HWY_INLINE V Load(const Row<double>& row, std::size_t k) { return hn::Load(F64(), row.data() + k); }
HWY_INLINE void Store(V value, Row<std::int32_t>& row, std::size_t k) {
    hn::Store(hn::DemoteTo(I32(), value), I32(), row.data() + k);
}
HWY_INLINE void Store(N value, Row<std::int64_t>& row, std::size_t k) {
    hn::Store(value, I64(), row.data() + k);
}

/// Whole numbers under 2^51 from one type to the other: added to this they stand in the fraction's last bits.
constexpr double whole_at = 6755399441055744.0; // 3 * 2^51
HWY_INLINE N WholeOf(V whole) {
    const N bits = hn::BitCast(I64(), Set(whole_at));
    return hn::Sub(hn::BitCast(I64(), hn::Add(whole, Set(whole_at))), bits);
}
HWY_INLINE V DoubleOf(N whole) {
    const N bits = hn::BitCast(I64(), Set(whole_at));
    return hn::Sub(hn::BitCast(F64(), hn::Add(whole, bits)), Set(whole_at));
}

/// 1 where true, else 0.
HWY_INLINE N Count(M where) {
    return hn::BitCast(I64(), hn::IfThenElseZero(where, hn::BitCast(F64(), hn::Set(I64(), 1))));
}

/// base + dividend / divisor in units of 2^-40, rounded down, modulo 2^64; as fixed_quotient(). Whole numbers.
HWY_INLINE N FixedQuotient(V base, V dividend, V divisor) {
    const V whole = hn::Floor(hn::Div(dividend, divisor));
    const V rest = hn::Sub(dividend, hn::Mul(whole, divisor));
    constexpr double one = std::int64_t{1} << fraction_bits;
    const N fraction = WholeOf(hn::Floor(hn::Div(hn::Mul(rest, Set(one)), divisor)));
    const N left = hn::Sub(hn::ShiftLeft<fraction_bits>(WholeOf(rest)), hn::Mul(fraction, WholeOf(divisor)));
    const N quotient = hn::Add(hn::ShiftLeft<fraction_bits>(WholeOf(hn::Add(base, whole))), fraction);
    return hn::Add(quotient, hn::ShiftRight<63>(left)); // -1 where the fraction was rounded up
}

/// As first_line_at().
HWY_INLINE V FirstLineAt(V coordinate) {
    return hn::Floor(hn::Mul(hn::Add(coordinate, Set(127.0)), Set(1.0 / 256.0)));
}

/// What the edges of some faces have in common.
struct Sides {
    V first_line, end_line;
    V reference_element; ///< where the last leading edge that begins on the face's first line crosses it
    N leading, trailing; ///< edges so far
};

/// A number for a trailing edge, until it is known how many edges lead, and one for an edge that is none.
constexpr std::int64_t trailing_place = -8, no_place = 8;

/// Side `side` of faces [k, k + lanes).
HWY_INLINE void MakeSide(Batch& batch, std::size_t k, std::size_t side, Sides& sides) {
    const std::size_t next = side + 1 == batch.corners ? 0 : side + 1;
    const V from = Load(batch.line[side], k), to = Load(batch.line[next], k);
    const V from_element = Load(batch.element[side], k), to_element = Load(batch.element[next], k);
    const M leads = hn::Lt(to, from);
    const V upper = hn::Min(from, to), lower = hn::Max(from, to);
    const V upper_element = hn::IfThenElse(leads, to_element, from_element);
    const V lower_element = hn::IfThenElse(leads, from_element, to_element);
    const V first_line = hn::Max(FirstLineAt(upper), Set(0.0));
    const V end_line = hn::Min(FirstLineAt(lower), Set(batch.lines));
    const M there = hn::Lt(first_line, end_line);

    const V height = hn::Max(hn::Sub(lower, upper), Set(1.0)); // of one that is not there
    const V width = hn::Sub(lower_element, upper_element);
    const V down = hn::Sub(hn::Add(hn::Mul(first_line, Set(256.0)), Set(128.0)), upper);
    const N start = hn::Add(FixedQuotient(upper_element, hn::Mul(down, width), height),
                            hn::Set(I64(), crossing_to_start));
    const M several = hn::Gt(hn::Sub(end_line, first_line), Set(1.0));
    const N slope = FixedQuotient(Set(0.0), hn::Mul(width, Set(256.0)), height);
    Store(first_line, batch.edge_first_line[side], k);
    Store(end_line, batch.edge_end_line[side], k);
    Store(start, batch.start[side], k);
    Store(hn::IfThenElseZero(hn::RebindMask(I64(), several), slope), batch.slope[side], k);

    const M leading = hn::And(there, leads), trailing = hn::AndNot(leads, there);
    const N trailing_at = hn::Add(sides.trailing, hn::Set(I64(), trailing_place));
    const N place = hn::IfThenElse(hn::RebindMask(I64(), leads), sides.leading, trailing_at);
    Store(hn::IfThenElse(hn::RebindMask(I64(), there), place, hn::Set(I64(), no_place)), batch.place[side],
          k);
    sides.leading = hn::Add(sides.leading, Count(leading));
    sides.trailing = hn::Add(sides.trailing, Count(trailing));
    const M earlier = hn::And(there, hn::Lt(first_line, sides.first_line));
    const M reference = hn::And(leading, hn::Le(first_line, sides.first_line));
    sides.reference_element = hn::IfThenElse(reference, DoubleOf(hn::ShiftRight<crossing_bits>(start)),
                                             hn::IfThenZeroElse(earlier, sides.reference_element));
    sides.first_line = hn::IfThenElse(there, hn::Min(sides.first_line, first_line), sides.first_line);
    sides.end_line = hn::IfThenElse(there, hn::Max(sides.end_line, end_line), sides.end_line);
}

/// A value of an intensity plane modulo 2^32, in the lower bits; as to_plane_units().
HWY_INLINE N ToPlaneUnits(V value) {
    const V bounded = hn::Min(hn::Max(value, Set(-plane_bound)), Set(plane_bound));
    const V whole = hn::Floor(hn::Add(bounded, Set(0.5)));
    const V wraps = hn::Floor(hn::Mul(whole, Set(1.0 / 4294967296.0)));
    return WholeOf(hn::Sub(whole, hn::Mul(wraps, Set(4294967296.0))));
}

/// As make_plane().
HWY_INLINE void MakePlane(Batch& batch, std::size_t k, V line, V element) {
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
    const V along = hn::IfThenElseZero(slopes, hn::Div(hn::Sub(hn::Mul(i1, l2), hn::Mul(i2, l1)), divisor));
    const V across = hn::IfThenElseZero(slopes, hn::Div(hn::Sub(hn::Mul(e1, i2), hn::Mul(e2, i1)), divisor));
    const V from_corner_e = hn::Sub(hn::Add(hn::Mul(element, Set(256.0)), Set(128.0)), element_0);
    const V from_corner_l = hn::Sub(hn::Add(hn::Mul(line, Set(256.0)), Set(128.0)), line_0);
    const V value = hn::Add(hn::Add(i_0, hn::Mul(along, from_corner_e)), hn::Mul(across, from_corner_l));
    Store(ToPlaneUnits(value), batch.value, k);
    Store(ToPlaneUnits(hn::Mul(along, Set(256.0))), batch.along, k);
    Store(ToPlaneUnits(hn::Mul(across, Set(256.0))), batch.across, k);
    Store(hn::Min(i_0, hn::Min(i_1, i_2)), batch.least, k);
    Store(hn::Max(i_0, hn::Max(i_1, i_2)), batch.greatest, k);
}

/// Faces [k, k + lanes).
HWY_INLINE void MakeFaces(Batch& batch, std::size_t k) {
    Sides sides{.first_line = Set(batch.lines),
                .end_line = Set(0.0),
                .reference_element = Set(0.0),
                .leading = hn::Zero(I64()),
                .trailing = hn::Zero(I64())};
    for (std::size_t side = 0; side < batch.corners; ++side)
        MakeSide(batch, k, side, sides);
    const N edges = hn::Add(sides.leading, sides.trailing);
    const N behind_leading = hn::Sub(sides.leading, hn::Set(I64(), trailing_place));
    for (std::size_t side = 0; side < batch.corners; ++side) {
        const N place = hn::Load(I64(), batch.place[side].data() + k);
        const auto trails = hn::Lt(place, hn::Zero(I64()));
        Store(hn::Min(hn::Add(place, hn::IfThenElseZero(trails, behind_leading)), edges), batch.place[side],
              k);
    }
    Store(sides.leading, batch.leading, k);
    Store(edges, batch.edges, k);
    Store(sides.first_line, batch.first_line, k);
    Store(sides.end_line, batch.end_line, k);
    const V element = hn::Min(hn::Max(sides.reference_element, Set(0.0)), Set(batch.elements - 1));
    Store(element, batch.reference_element, k);
    MakePlane(batch, k, sides.first_line, element);
}

void MakeBatch(Batch& batch) {
    for (std::size_t k = 0; k < batch.count; k += hn::Lanes(F64()))
        MakeFaces(batch, k);
}

} // namespace HWY_NAMESPACE
} // namespace linkdig::ig
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace linkdig::ig {

namespace {

HWY_EXPORT(MakeBatch);

} // namespace

std::size_t make_edges_together(const ProjectedFaces& projected, std::size_t rank, std::int32_t lines,
                                std::int32_t elements, FaceEdges& out, std::size_t& edges_made) {
    if (simd_is_off()) return 0;
    Batch batch;
    batch.lines = lines;
    batch.elements = elements;
    fill(projected, rank, batch);
    if (batch.count == 0) return 0;
    HWY_DYNAMIC_DISPATCH(MakeBatch)(batch);
    write(projected, rank, batch, out, edges_made);
    return batch.count;
}

} // namespace linkdig::ig
#endif
