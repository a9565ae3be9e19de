#include "ig/geometry/face_sieve.h"

#include "ig/simd/simd_level.h"

#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "ig/geometry/face_sieve.cpp"
#include <hwy/foreach_target.h> // compiles this file once for every SIMD level
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace linkdig::ig {
namespace HWY_NAMESPACE {

#if HWY_TARGET != HWY_SCALAR

namespace hn = hwy::HWY_NAMESPACE;

using I32x4 = hn::Full128<std::int32_t>; ///< line, element, intensity, outside: a SeenVertex
using I64x2 = hn::Full128<std::int64_t>;
using V = hn::Vec<I32x4>;

HWY_INLINE std::uint32_t SignBits(hn::Vec<I64x2> value) {
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(I64x2(), hn::MaskFromVec(hn::BroadcastSignBit(value)), bits);
    return bits[0];
}

constexpr std::int32_t frustum_sides = before_near | left_of | right_of | below | above;

/// What a face's corners have in common, and the areas of the first two triangles that fan out from its first corner.
struct Corners {
    V least, most, all, any;
    hn::Vec<I64x2> areas;
};

HWY_INLINE void Add(V corner, Corners& corners) {
    corners.least = hn::Min(corners.least, corner);
    corners.most = hn::Max(corners.most, corner);
    corners.all = hn::And(corners.all, corner);
    corners.any = hn::Or(corners.any, corner);
}

/// Twice the signed areas in (element, line): e b.line - ..., of differences (line, element) in two lanes each.
HWY_INLINE hn::Vec<I64x2> Areas(V from, V to) {
    const V to_turned = hn::Shuffle2301(to);
    return hn::Sub(hn::MulEven(hn::Shuffle2301(from), to), hn::MulEven(from, to_turned));
}

HWY_INLINE Corners Take(const SeenVertex* seen, const std::uint32_t* corners, std::uint32_t count) {
    const I64x2 pairs;
    const I32x4 d;
    const auto at = [&](std::uint32_t k)
                        HWY_ATTR { return hn::Load(I32x4(), &seen[corners[k]].snapped.line); };
    const V first = at(0), second = at(1), third = at(2), fourth = at(count > 3 ? 3 : 2);
    Corners taken{hn::Min(hn::Min(first, second), hn::Min(third, fourth)),
                  hn::Max(hn::Max(first, second), hn::Max(third, fourth)),
                  hn::And(hn::And(first, second), hn::And(third, fourth)),
                  hn::Or(hn::Or(first, second), hn::Or(third, fourth)), hn::Zero(pairs)};
    const auto side = [&](V corner) HWY_ATTR { return hn::BitCast(pairs, hn::Sub(corner, first)); };
    taken.areas = Areas(hn::BitCast(d, hn::InterleaveLower(pairs, side(second), side(third))),
                        hn::BitCast(d, hn::InterleaveLower(pairs, side(third), side(fourth))));
    for (std::uint32_t k = 4; k < count; ++k)
        Add(at(k), taken);
    return taken;
}

bool SiftFaces(const FaceSieve& sieve, const FaceBlock& block, const SeenVertex* seen, std::uint32_t first,
               std::uint32_t count, SiftedFaces& left) {
    const I32x4 d;
    const I64x2 pairs;
    constexpr std::int32_t greatest = std::numeric_limits<std::int32_t>::max();
    alignas(16) const std::int32_t ends[4] = {sieve.last_line, sieve.last_element, greatest, greatest};
    alignas(16) const std::int32_t begins[4] = {0, 0, -1, -1};
    const V end = hn::Load(d, ends);
    const V begin = hn::Load(d, begins);
    const V half = hn::Set(d, 127);
    const std::uint32_t front = sieve.vertical ? 0 : 3;
    std::uint32_t made = 0;
    for (std::uint32_t f = first; f < first + count; ++f) {
        const Face& face = block.faces[f];
        const Corners corners = Take(seen, block.corners.data() + face.first_corner, face.corner_count);
        const bool inside = hn::AllTrue(d, hn::And(hn::Gt(corners.most, begin), hn::Lt(corners.least, end)));
        const V same = hn::Xor(hn::ShiftRight<8>(hn::Add(corners.most, half)),
                               hn::ShiftRight<8>(hn::Add(corners.least, half)));
        const std::int32_t lines = hn::GetLane(same);
        const std::int32_t all = hn::ExtractLane(corners.all, 3);
        const std::int32_t any = hn::ExtractLane(corners.any, 3);
        const bool whole = (any & (before_near | guard)) == 0;
        const auto negative = SignBits(corners.areas);
        const auto positive = SignBits(hn::Sub(hn::Zero(pairs), corners.areas));
        const auto facing =
            (front != 0 ? negative : positive) | (face.two_sided != 0 ? negative | positive : 0);
        const bool faces_us = (facing != 0) | (face.corner_count > 4);
        const bool seen_whole = inside & faces_us & (sieve.low_faces | (lines != 0));
        const bool stays = ((all & frustum_sides) == 0) & (!whole | seen_whole);
        const bool level = hn::ExtractLane(corners.least, 2) == hn::ExtractLane(corners.most, 2);
        left.faces[made] = {f, whole, block.smooth & (face.shading == Shading::vertex) & !level};
        made += stays ? 1 : 0;
    }
    left.count = made;
    return true;
}

#else

bool SiftFaces(const FaceSieve& /*sieve*/, const FaceBlock& /*block*/, const SeenVertex* /*seen*/,
               std::uint32_t /*first*/, std::uint32_t /*count*/, SiftedFaces& /*left*/) {
    return false;
}

#endif

} // namespace HWY_NAMESPACE
} // namespace linkdig::ig
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace linkdig::ig {

namespace {

HWY_EXPORT(SiftFaces);

} // namespace

bool sift_faces(const FaceSieve& sieve, const FaceBlock& block, const SeenVertex* seen, std::uint32_t first,
                std::uint32_t count, SiftedFaces& left) {
    return !simd_is_off() && HWY_DYNAMIC_DISPATCH(SiftFaces)(sieve, block, seen, first, count, left);
}

} // namespace linkdig::ig
#endif
