#include "ig/geometry/vertex_batch.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "ig/geometry/vertex_batch.cpp"
#include <hwy/foreach_target.h> // compiles this file once for every SIMD level
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace linkdig::ig {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using F64 = hn::CappedTag<double, 8>;
using F32 = hn::Rebind<float, F64>;
using I32 = hn::Rebind<std::int32_t, F64>;
using V = hn::Vec<F64>;

HWY_INLINE V Set(double value) { return hn::Set(F64(), value); }

/// As snap(): floor(value + 0.5). Nobody uses a place outside the guard band, or none at all (z = 0), but it must have a number.
HWY_INLINE hn::Vec<I32> Snapped(V value) {
    const auto number = hn::IfThenElseZero(hn::Eq(value, value), value);
    const auto inside = hn::Min(hn::Max(number, Set(-guard_limit)), Set(guard_limit));
    return hn::DemoteTo(I32(), hn::Floor(hn::Add(inside, Set(0.5))));
}

/// Component `row` of channel_from_list * position + w * origin.
HWY_INLINE V Transformed(const BlockView& view, int row, V x, V y, V z, V w) {
    const Mat3d& m = view.channel_from_list;
    const auto turned =
        hn::Add(hn::Add(hn::Mul(Set(m[0][row]), x), hn::Mul(Set(m[1][row]), y)), hn::Mul(Set(m[2][row]), z));
    return hn::Add(turned, hn::Mul(w, Set(view.origin[row])));
}

HWY_INLINE V OnRaster(double scale, V along, V z, double offset) {
    return hn::Add(hn::Mul(Set(scale), hn::Div(along, z)), Set(offset));
}

/// As lit_intensity().
HWY_INLINE hn::Vec<I32> Lit(const FaceBlock& block, const VertexBatch& batch, std::size_t k) {
    const F32 d;
    const auto part = [&](std::size_t c, float sun) HWY_ATTR {
        return hn::Mul(hn::Load(d, batch.normal[c].data() + k), hn::Set(d, sun));
    };
    const auto cosine = hn::Add(hn::Add(part(0, block.sun.x), part(1, block.sun.y)), part(2, block.sun.z));
    const auto intensity =
        hn::Add(hn::Set(d, block.ambient), hn::Mul(hn::Set(d, block.diffuse), hn::Max(hn::Zero(d), cosine)));
    const auto clamped = hn::Min(hn::Max(intensity, hn::Zero(d)), hn::Set(d, 1.0F));
    return hn::ConvertTo(
        I32(), hn::Add(hn::Mul(clamped, hn::Set(d, static_cast<float>(intensity_one))), hn::Set(d, 0.5F)));
}

HWY_INLINE V Flag(hn::Mask<F64> outside, Outside side) {
    return hn::IfThenElseZero(outside, Set(static_cast<double>(side)));
}

void SeeBatch(const BlockView& sight, VertexBatch& batch) {
    const F64 d;
    const View& view = *sight.view;
    for (std::size_t k = 0; k < batch.count; k += hn::Lanes(d)) {
        const auto given = [&](std::size_t c) HWY_ATTR {
            return hn::PromoteTo(d, hn::Load(F32(), batch.position[c].data() + k));
        };
        const auto px = given(0), py = given(1), pz = given(2), w = given(3);
        const auto x = Transformed(sight, 0, px, py, pz, w);
        const auto y = Transformed(sight, 1, px, py, pz, w);
        const auto z = Transformed(sight, 2, px, py, pz, w);
        const auto distance =
            hn::Sub(hn::Add(z, hn::Mul(Set(least_forward - near_plane_m), w)), Set(least_forward));
        const auto before = hn::Lt(distance, hn::Zero(d));
        const auto column = OnRaster(view.scale.x_scale, x, z, view.scale.x_offset);
        const auto row = OnRaster(view.scale.y_scale, y, z, view.scale.y_offset);
        const auto line = view.vertical ? column : row;
        const auto element = view.vertical ? row : column;
        hn::Store(Snapped(line), I32(), batch.snapped_line.data() + k);
        hn::Store(Snapped(element), I32(), batch.snapped_element.data() + k);

        const auto far_off =
            hn::Or(hn::Gt(hn::Abs(line), Set(guard_limit)), hn::Gt(hn::Abs(element), Set(guard_limit)));
        auto outside = hn::Add(Flag(before, before_near), Flag(hn::AndNot(before, far_off), guard));
        outside = hn::Add(outside, Flag(hn::Lt(x, hn::Mul(Set(view.left), z)), left_of));
        outside = hn::Add(outside, Flag(hn::Gt(x, hn::Mul(Set(view.right), z)), right_of));
        outside = hn::Add(outside, Flag(hn::Lt(y, hn::Mul(Set(view.bottom), z)), below));
        outside = hn::Add(outside, Flag(hn::Gt(y, hn::Mul(Set(view.top), z)), above));
        hn::Store(hn::DemoteTo(I32(), outside), I32(), batch.outside.data() + k);
        hn::Store(Lit(*sight.block, batch, k), I32(), batch.intensity.data() + k);
    }
}

} // namespace HWY_NAMESPACE
} // namespace linkdig::ig
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace linkdig::ig {

namespace {

HWY_EXPORT(SeeBatch);

} // namespace

void see_batch(const BlockView& view, VertexBatch& batch) { HWY_DYNAMIC_DISPATCH(SeeBatch)(view, batch); }

} // namespace linkdig::ig
#endif
