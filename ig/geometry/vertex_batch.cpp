#include "ig/geometry/vertex_batch.h"

#include "ig/simd/simd_level.h"

#include <algorithm>
#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "ig/geometry/vertex_batch.cpp"
#include <hwy/foreach_target.h> // compiles this file once for every SIMD level
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace linkdig::ig {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

#if HWY_TARGET != HWY_SCALAR

using F64 = hn::CappedTag<double, vertices_together>;
using F32 = hn::Rebind<float, F64>;
using I32 = hn::Rebind<std::int32_t, F64>;
using F32x4 = hn::Full128<float>;
using V = hn::Vec<F64>;

/// Components of vertices, each in a row of its own.
struct Rows {
    static constexpr std::size_t room = 64;
    alignas(64) float position[4][room];
    alignas(64) float normal[3][room];
};

HWY_INLINE V Set(double value) { return hn::Set(F64(), value); }

/// Of four vertices, from row place k on. Position and normal are two vectors that have w in common.
HWY_INLINE void TakeFour(const Vertex* vertices, std::size_t k, Rows& rows) {
    const F32x4 d;
    const auto position = [&](std::size_t v) HWY_ATTR { return hn::LoadU(d, &vertices[v].position.x); };
    const auto normal = [&](std::size_t v) HWY_ATTR { return hn::LoadU(d, &vertices[v].position.w); };
    const auto xy02 = hn::InterleaveLower(d, position(0), position(2));
    const auto xy13 = hn::InterleaveLower(d, position(1), position(3));
    const auto zw02 = hn::InterleaveUpper(d, position(0), position(2));
    const auto zw13 = hn::InterleaveUpper(d, position(1), position(3));
    hn::Store(hn::InterleaveLower(d, xy02, xy13), d, rows.position[0] + k);
    hn::Store(hn::InterleaveUpper(d, xy02, xy13), d, rows.position[1] + k);
    hn::Store(hn::InterleaveLower(d, zw02, zw13), d, rows.position[2] + k);
    hn::Store(hn::InterleaveUpper(d, zw02, zw13), d, rows.position[3] + k);
    const auto wx02 = hn::InterleaveLower(d, normal(0), normal(2));
    const auto wx13 = hn::InterleaveLower(d, normal(1), normal(3));
    const auto yz02 = hn::InterleaveUpper(d, normal(0), normal(2));
    const auto yz13 = hn::InterleaveUpper(d, normal(1), normal(3));
    hn::Store(hn::InterleaveUpper(d, wx02, wx13), d, rows.normal[0] + k);
    hn::Store(hn::InterleaveLower(d, yz02, yz13), d, rows.normal[1] + k);
    hn::Store(hn::InterleaveUpper(d, yz02, yz13), d, rows.normal[2] + k);
}

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
HWY_INLINE hn::Vec<I32> Lit(const FaceBlock& block, const Rows& rows, std::size_t k) {
    const F32 d;
    const auto part = [&](std::size_t c, float sun)
                          HWY_ATTR { return hn::Mul(hn::Load(d, rows.normal[c] + k), hn::Set(d, sun)); };
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

/// A vector of vertices, those in the rows from k on.
HWY_INLINE void SeeRows(const BlockView& sight, const Rows& rows, std::size_t k, SeenVertex* seen) {
    const F64 d;
    const View& view = *sight.view;
    const auto given = [&](std::size_t c)
                           HWY_ATTR { return hn::PromoteTo(d, hn::Load(F32(), rows.position[c] + k)); };
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
    const auto far_off =
        hn::Or(hn::Gt(hn::Abs(line), Set(guard_limit)), hn::Gt(hn::Abs(element), Set(guard_limit)));
    auto outside = hn::Add(Flag(before, before_near), Flag(hn::AndNot(before, far_off), guard));
    outside = hn::Add(outside, Flag(hn::Lt(x, hn::Mul(Set(view.left), z)), left_of));
    outside = hn::Add(outside, Flag(hn::Gt(x, hn::Mul(Set(view.right), z)), right_of));
    outside = hn::Add(outside, Flag(hn::Lt(y, hn::Mul(Set(view.bottom), z)), below));
    outside = hn::Add(outside, Flag(hn::Gt(y, hn::Mul(Set(view.top), z)), above));
    hn::StoreInterleaved4(Snapped(line), Snapped(element), Lit(*sight.block, rows, k),
                          hn::DemoteTo(I32(), outside), I32(), &seen->snapped.line);
}

/// Returns whether they have been seen.
bool SeeGroups(const BlockView& view, std::span<const std::uint32_t> groups, SeenVertex* seen) {
    constexpr std::size_t groups_of_rows = Rows::room / vertices_together;
    Rows rows;
    const std::size_t lanes = hn::Lanes(F64());
    for (std::size_t first = 0; first < groups.size(); first += groups_of_rows) {
        const auto here = groups.subspan(first, std::min(groups.size() - first, groups_of_rows));
        for (std::size_t g = 0; g < here.size(); ++g)
            for (std::size_t k = 0; k < vertices_together; k += 4)
                TakeFour(view.block->vertices.data() + here[g] * vertices_together + k,
                         g * vertices_together + k, rows);
        for (std::size_t g = 0; g < here.size(); ++g)
            for (std::size_t k = 0; k < vertices_together; k += lanes)
                SeeRows(view, rows, g * vertices_together + k, seen + here[g] * vertices_together + k);
    }
    return true;
}

Reach ReachOf(std::span<const std::uint32_t> indices) {
    const hn::CappedTag<std::uint32_t, 16> d;
    const std::size_t lanes = hn::Lanes(d);
    Reach reach{indices[0], indices[0]};
    std::size_t k = 0;
    if (indices.size() >= lanes) {
        auto least = hn::LoadU(d, indices.data() + indices.size() - lanes);
        auto greatest = least;
        for (; k + lanes <= indices.size(); k += lanes) {
            least = hn::Min(least, hn::LoadU(d, indices.data() + k));
            greatest = hn::Max(greatest, hn::LoadU(d, indices.data() + k));
        }
        return {hn::GetLane(hn::MinOfLanes(d, least)), hn::GetLane(hn::MaxOfLanes(d, greatest))};
    }
    for (; k < indices.size(); ++k) {
        reach.least = std::min(reach.least, indices[k]);
        reach.greatest = std::max(reach.greatest, indices[k]);
    }
    return reach;
}

#else

bool SeeGroups(const BlockView& /*view*/, std::span<const std::uint32_t> /*groups*/, SeenVertex* /*seen*/) {
    return false;
}

Reach ReachOf(std::span<const std::uint32_t> indices) {
    const auto [least, greatest] = std::ranges::minmax(indices);
    return {least, greatest};
}

#endif

} // namespace HWY_NAMESPACE
} // namespace linkdig::ig
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace linkdig::ig {

namespace {

HWY_EXPORT(SeeGroups);
HWY_EXPORT(ReachOf);

std::int32_t outside(const View& view, const ClipPoint& p) {
    std::int32_t sides = 0;
    if (near_plane(p) < 0.0) sides |= before_near;
    if (p.x < view.left * p.z) sides |= left_of;
    if (p.x > view.right * p.z) sides |= right_of;
    if (p.y < view.bottom * p.z) sides |= below;
    if (p.y > view.top * p.z) sides |= above;
    return sides;
}

void place(const View& view, const ClipPoint& point, SeenVertex& seen) {
    double line = 0;
    double element = 0;
    raster_position(view, point, line, element);
    if (std::fabs(line) > guard_limit || std::fabs(element) > guard_limit) {
        seen.outside |= guard;
        return;
    }
    seen.snapped = {static_cast<std::int32_t>(snap(line)), static_cast<std::int32_t>(snap(element))};
}

} // namespace

ClipPoint channel_point(const BlockView& view, const Vec4f& position, std::int32_t intensity) {
    const Vec3d p = view.channel_from_list * Vec3d(position) + static_cast<double>(position.w) * view.origin;
    return {p.x, p.y, p.z, static_cast<double>(position.w), static_cast<double>(intensity)};
}

void raster_position(const View& view, const ClipPoint& point, double& line, double& element) {
    const double column = view.scale.x_scale * (point.x / point.z) + view.scale.x_offset;
    const double row = view.scale.y_scale * (point.y / point.z) + view.scale.y_offset;
    line = view.vertical ? column : row;
    element = view.vertical ? row : column;
}

void see_plainly(const BlockView& view, const Vertex& vertex, SeenVertex& seen) {
    const ClipPoint point = channel_point(view, vertex.position);
    seen.outside = outside(*view.view, point);
    if ((seen.outside & before_near) == 0) place(*view.view, point, seen);
    seen.intensity = lit_intensity(*view.block, vertex.normal);
}

void see_vertices(const BlockView& view, std::span<const std::uint32_t> groups, SeenVertex* seen) {
    const std::span<const Vertex> vertices = view.block->vertices;
    const auto plainly = [&](std::uint32_t group) {
        const auto end = std::min<std::size_t>(vertices.size(), (std::size_t{group} + 1) * vertices_together);
        for (std::size_t v = std::size_t{group} * vertices_together; v < end; ++v)
            see_plainly(view, vertices[v], seen[v]);
    };
    if (groups.empty()) return;
    // The block's last group may lack some.
    const auto whole = static_cast<std::uint32_t>(vertices.size() / vertices_together);
    const auto partial = std::ranges::find(groups, whole);
    if (simd_is_off() || partial != groups.end() || !HWY_DYNAMIC_DISPATCH(SeeGroups)(view, groups, seen))
        std::ranges::for_each(groups, plainly);
}

Reach reach_of(std::span<const std::uint32_t> indices) { return HWY_DYNAMIC_DISPATCH(ReachOf)(indices); }

std::int32_t lit_intensity(const FaceBlock& block, const Vec3f& normal) {
    const float cosine = normal.x * block.sun.x + normal.y * block.sun.y + normal.z * block.sun.z;
    const float intensity = block.ambient + block.diffuse * std::max(0.0F, cosine);
    return static_cast<std::int32_t>(std::clamp(intensity, 0.0F, 1.0F) * static_cast<float>(intensity_one) +
                                     0.5F);
}

} // namespace linkdig::ig
#endif
