#include "ig/geometry/depth_batch.h"

#include "ig/geometry/depth_plane.h"
#include "ig/simd/simd_level.h"

#include <algorithm>
#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "ig/geometry/depth_batch.cpp"
#include <hwy/foreach_target.h> // compiles this file once for every SIMD level
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace linkdig::ig {
namespace HWY_NAMESPACE {

/// A bit for each of the faces.
using FaceBits = std::uint64_t;
static_assert(depths_together <= 64);

#if HWY_TARGET != HWY_SCALAR

namespace hn = hwy::HWY_NAMESPACE;

using F64 = hn::CappedTag<double, 8>;
using F32 = hn::Rebind<float, F64>;
using F32x4 = hn::Full128<float>;
using V = hn::Vec<F64>;

/// Faces side by side: what is asked of them in rows, and what comes out. A row is written for all of them before any is read:
/// what has just been stored in other pieces is slow to load.
struct Rows {
    /// Corners: of the first, into the block's corners; and the number of the last.
    const std::uint32_t* first[depths_together];
    std::uint32_t last[depths_together];
    /// Corner by corner, x, y, z, w in the list's frame. A triangle's third counts twice, if others have a fourth.
    alignas(64) float corner[4][4][depths_together];
    /// inverse_m, across, along, nearest_m, and farthest_m.
    alignas(64) double plane[depths_together][4];
    alignas(64) double farthest_m[depths_together];
    std::size_t end = 0; ///< of the places that are in use: whole vectors
    FaceBits plain = 0;  ///< faces that vectors do not make a plane of
    FaceBits fourth = 0; ///< faces of more than three corners
};

/// Four positions, from row place f on.
HWY_INLINE void TakeFour(const Vec4f& a, const Vec4f& b, const Vec4f& c, const Vec4f& d, std::size_t f,
                         float (&row)[4][depths_together]) {
    const F32x4 tag;
    const auto va = hn::LoadU(tag, &a.x), vb = hn::LoadU(tag, &b.x);
    const auto vc = hn::LoadU(tag, &c.x), vd = hn::LoadU(tag, &d.x);
    const auto xy_ac = hn::InterleaveLower(tag, va, vc), zw_ac = hn::InterleaveUpper(tag, va, vc);
    const auto xy_bd = hn::InterleaveLower(tag, vb, vd), zw_bd = hn::InterleaveUpper(tag, vb, vd);
    hn::Store(hn::InterleaveLower(tag, xy_ac, xy_bd), tag, row[0] + f);
    hn::Store(hn::InterleaveUpper(tag, xy_ac, xy_bd), tag, row[1] + f);
    hn::Store(hn::InterleaveLower(tag, zw_ac, zw_bd), tag, row[2] + f);
    hn::Store(hn::InterleaveUpper(tag, zw_ac, zw_bd), tag, row[3] + f);
}

/// Where the faces' corners stand, and which faces are out of the ordinary. Where a vector's last lanes have no face, they take
/// the last one again.
HWY_INLINE void FindCorners(const FaceBlock& block, std::span<const std::uint32_t> faces, Rows& rows) {
    const std::size_t lanes = std::max<std::size_t>(hn::Lanes(F64()), 4);
    FaceBits fourth = 0, plain = 0;
    for (std::size_t f = 0; f < faces.size(); ++f) {
        const Face& face = block.faces[faces[f]];
        rows.first[f] = block.corners.data() + face.first_corner;
        rows.last[f] = face.corner_count - 1U;
        fourth |= FaceBits{face.corner_count > 3} << f;
        plain |= FaceBits{face.corner_count > 4} << f;
    }
    rows.fourth = fourth;
    rows.plain = plain;
    rows.end = (faces.size() + lanes - 1) / lanes * lanes;
    for (std::size_t f = faces.size(); f < rows.end; ++f) {
        rows.first[f] = rows.first[f - 1];
        rows.last[f] = rows.last[f - 1];
    }
}

/// Corner c of all faces.
template <std::uint32_t c>
HWY_INLINE void TakeCorners(const Vertex* vertices, Rows& rows) {
    const auto at = [&](std::size_t f) -> const Vec4f& {
        return vertices[rows.first[f][c < 3 ? c : std::min(c, rows.last[f])]].position;
    };
    for (std::size_t f = 0; f < rows.end; f += 4)
        TakeFour(at(f), at(f + 1), at(f + 2), at(f + 3), f, rows.corner[c]);
}

HWY_INLINE V Set(double value) { return hn::Set(F64(), value); }

/// Component `row` of channel_from_list * position + w * origin.
HWY_INLINE V Transformed(const BlockView& view, int row, V x, V y, V z, V w) {
    const Mat3d& m = view.channel_from_list;
    const auto turned =
        hn::Add(hn::Add(hn::Mul(Set(m[0][row]), x), hn::Mul(Set(m[1][row]), y)), hn::Mul(Set(m[2][row]), z));
    return hn::Add(turned, hn::Mul(w, Set(view.origin[row])));
}

/// Bits of the faces from f on, a vector of them, that have a corner at infinity.
template <bool fourth>
HWY_INLINE FaceBits Infinite(const Rows& rows, std::size_t f) {
    const F32 d;
    const auto at_infinity = [&](std::size_t corner) HWY_ATTR {
        return hn::Eq(hn::Load(d, rows.corner[corner][3] + f), hn::Zero(d));
    };
    auto some = hn::Or(hn::Or(at_infinity(0), at_infinity(1)), at_infinity(2));
    if constexpr (fourth) some = hn::Or(some, at_infinity(3));
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(d, some, bits);
    return FaceBits{bits[0]} << f;
}

/// A corner in the channel frame, of faces from f on.
HWY_INLINE void CornerAt(const BlockView& view, const float (&row)[4][depths_together], std::size_t f, V& x,
                         V& y, V& z) {
    const F64 d;
    const auto given = [&](std::size_t c) HWY_ATTR { return hn::PromoteTo(d, hn::Load(F32(), row[c] + f)); };
    const auto px = given(0), py = given(1), pz = given(2), w = given(3);
    x = Transformed(view, 0, px, py, pz, w);
    y = Transformed(view, 1, px, py, pz, w);
    z = Transformed(view, 2, px, py, pz, w);
}

HWY_INLINE V Dot(V ax, V ay, V az, V bx, V by, V bz) {
    return hn::Add(hn::Add(hn::Mul(ax, bx), hn::Mul(ay, by)), hn::Mul(az, bz));
}

HWY_INLINE V Square(V x, V y, V z) { return Dot(x, y, z, x, y, z); }

/// A component of a cross product.
HWY_INLINE V Minor(V a, V d, V b, V c) { return hn::Sub(hn::Mul(a, d), hn::Mul(b, c)); }

/// Where the planes n.(x, y, z) = offset of faces from f on lie on the screen, and the bounds of the range; infinitely far where
/// the eye is in the plane, or the face has no area. As depth_plane() and bound_range() do it: a plane differs in its last bits,
/// and with it pixels in haze, if an operation changes places.
HWY_INLINE void StorePlanes(const View& view, V nx, V ny, V nz, V offset, V length, V size, V farthest,
                            std::size_t f, Rows& rows) {
    const F64 d;
    const auto none = hn::Le(hn::Abs(offset), hn::Mul(Set(1e-9), length));
    const auto infinity = Set(std::numeric_limits<double>::infinity());
    const auto reciprocal = hn::Div(Set(1.0), offset);
    const auto ix = hn::Mul(nx, reciprocal), iy = hn::Mul(ny, reciprocal), iz = hn::Mul(nz, reciprocal);
    const auto x_scale = Set(view.scale.x_scale), y_scale = Set(view.scale.y_scale);
    const auto per_column = hn::Div(hn::Mul(ix, Set(256.0)), x_scale);
    const auto per_row = hn::Div(hn::Mul(iy, Set(256.0)), y_scale);
    const auto inverse_m = hn::Add(hn::Add(hn::Div(hn::Mul(ix, Set(128.0 - view.scale.x_offset)), x_scale),
                                           hn::Div(hn::Mul(iy, Set(128.0 - view.scale.y_offset)), y_scale)),
                                   iz);
    const auto nearest = hn::Max(hn::Div(hn::Abs(offset), length), hn::Sub(farthest, size));
    hn::StoreInterleaved4(hn::IfThenZeroElse(none, inverse_m),
                          hn::IfThenZeroElse(none, view.vertical ? per_column : per_row),
                          hn::IfThenZeroElse(none, view.vertical ? per_row : per_column),
                          hn::IfThenElse(none, infinity, nearest), d, rows.plane[f]);
    hn::Store(hn::IfThenElse(none, infinity, farthest), d, rows.farthest_m + f);
}

/// Faces from f on: all of three corners, or some of four. As normal_of() and size_of() do it.
template <bool fourth>
HWY_INLINE void MakeRows(const BlockView& view, std::size_t f, Rows& rows) {
    const F64 d;
    V x0, y0, z0, x1, y1, z1, x2, y2, z2;
    CornerAt(view, rows.corner[0], f, x0, y0, z0);
    CornerAt(view, rows.corner[1], f, x1, y1, z1);
    CornerAt(view, rows.corner[2], f, x2, y2, z2);
    const auto ax = hn::Sub(x1, x0), ay = hn::Sub(y1, y0), az = hn::Sub(z1, z0);
    const auto bx = hn::Sub(x2, x0), by = hn::Sub(y2, y0), bz = hn::Sub(z2, z0);
    auto nx = Minor(ay, bz, by, az), ny = Minor(az, bx, bz, ax), nz = Minor(ax, by, bx, ay);
    auto square = Square(nx, ny, nz);
    auto size = hn::Max(hn::Max(Square(ax, ay, az), Square(bx, by, bz)),
                        Square(hn::Sub(x2, x1), hn::Sub(y2, y1), hn::Sub(z2, z1)));
    auto farthest = hn::Max(hn::Max(Square(x0, y0, z0), Square(x1, y1, z1)), Square(x2, y2, z2));
    if constexpr (fourth) {
        V x3, y3, z3;
        CornerAt(view, rows.corner[3], f, x3, y3, z3);
        const auto cx = hn::Sub(x3, x0), cy = hn::Sub(y3, y0), cz = hn::Sub(z3, z0);
        const auto mx = Minor(ay, cz, cy, az), my = Minor(az, cx, cz, ax), mz = Minor(ax, cy, cx, ay);
        const auto other = Square(mx, my, mz);
        const auto larger = hn::Gt(other, square);
        nx = hn::IfThenElse(larger, mx, nx);
        ny = hn::IfThenElse(larger, my, ny);
        nz = hn::IfThenElse(larger, mz, nz);
        square = hn::IfThenElse(larger, other, square);
        size = hn::Max(hn::Max(size, Square(cx, cy, cz)),
                       hn::Max(Square(hn::Sub(x3, x1), hn::Sub(y3, y1), hn::Sub(z3, z1)),
                               Square(hn::Sub(x3, x2), hn::Sub(y3, y2), hn::Sub(z3, z2))));
        farthest = hn::Max(farthest, Square(x3, y3, z3));
    }
    // A normal whose square is 0, though it is not, counts as 0.
    const auto some = hn::Gt(square, hn::Zero(d));
    nx = hn::IfThenElseZero(some, nx);
    ny = hn::IfThenElseZero(some, ny);
    nz = hn::IfThenElseZero(some, nz);
    StorePlanes(*view.view, nx, ny, nz, Dot(nx, ny, nz, x0, y0, z0), hn::Sqrt(square), hn::Sqrt(size),
                hn::Sqrt(farthest), f, rows);
    rows.plain |= Infinite<fourth>(rows, f);
}

/// All faces, in rows: of three corners, or some of four.
template <bool fourth>
HWY_INLINE void MakeAllRows(const BlockView& view, Rows& rows) {
    const Vertex* const vertices = view.block->vertices.data();
    TakeCorners<0>(vertices, rows);
    TakeCorners<1>(vertices, rows);
    TakeCorners<2>(vertices, rows);
    if constexpr (fourth) TakeCorners<3>(vertices, rows);
    for (std::size_t f = 0; f < rows.end; f += hn::Lanes(F64()))
        MakeRows<fourth>(view, f, rows);
}

/// Returns the faces whose planes it has not made: those of more corners than four, or with one at infinity.
FaceBits MakePlanes(const BlockView& view, std::span<const std::uint32_t> faces, DepthPlane* planes) {
    Rows rows;
    FindCorners(*view.block, faces, rows);
    if (rows.fourth == 0)
        MakeAllRows<false>(view, rows);
    else
        MakeAllRows<true>(view, rows);
    for (std::size_t f = 0; f < faces.size(); ++f) {
        const double(&plane)[4] = rows.plane[f];
        planes[f] = {plane[0], plane[1], plane[2], plane[3], rows.farthest_m[f]};
    }
    return rows.plain;
}

#else

FaceBits MakePlanes(const BlockView& /*view*/, std::span<const std::uint32_t> /*faces*/,
                    DepthPlane* /*planes*/) {
    return ~FaceBits{0};
}

#endif

} // namespace HWY_NAMESPACE
} // namespace linkdig::ig
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace linkdig::ig {

namespace {

HWY_EXPORT(MakePlanes);

DepthPlane plane_of(const BlockView& view, const Face& face, std::vector<ClipPoint>& corners) {
    const FaceBlock& block = *view.block;
    corners.clear();
    for (const std::uint32_t vertex : block.corners.subspan(face.first_corner, face.corner_count))
        corners.push_back(channel_point(view, block.vertices[vertex].position));
    return depth_plane(*view.view, corners);
}

} // namespace

void make_depth_planes(const BlockView& view, std::span<const std::uint32_t> faces,
                       std::vector<ClipPoint>& corners, DepthPlane* planes) {
    if (faces.empty()) return;
    const std::uint64_t plain =
        simd_is_off() ? ~std::uint64_t{0} : HWY_DYNAMIC_DISPATCH(MakePlanes)(view, faces, planes);
    for (std::size_t f = 0; f < faces.size(); ++f)
        if ((plain >> f & 1U) != 0) planes[f] = plane_of(view, view.block->faces[faces[f]], corners);
}

} // namespace linkdig::ig
#endif
