#include "ig/geometry/face_sieve.h"

#include "ig/simd/simd_level.h"

#include <algorithm>
#include <bit>
#include <cstring>
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

/// Four lanes are a vertex: line, element, intensity, outside. One corner of several faces stands side by side.
#if HWY_HAVE_SCALABLE
using Wide = hn::Full128<std::int32_t>;
#else
using Wide = hn::CappedTag<std::int32_t, 16>;
#endif
using One = hn::Full128<std::int32_t>;

constexpr std::uint32_t at_once = hn::MaxLanes(Wide()) / 4;

/// Bits of faces that stand side by side: four each.
using Bits = std::uint32_t;
constexpr Bits each = 0x1111;

struct FaceCorners {
    const std::uint32_t* index = nullptr; ///< of vertices
    std::uint32_t count = 3;
};

/// The faces' first three corners, and their last one: a triangle's third counts twice.
enum class Place : std::uint8_t { first, second, third, last };

template <class D>
HWY_INLINE hn::Vec<D> CornerAt(D d, const SeenVertex* seen, const FaceCorners* faces, Place place) {
    if constexpr (hn::MaxLanes(d) == 4) {
        const std::uint32_t k = place == Place::last ? faces->count - 1 : static_cast<std::uint32_t>(place);
        return hn::Load(d, &seen[faces->index[k]].snapped.line);
    } else {
        const hn::Half<D> half;
        return hn::Combine(d, CornerAt(half, seen, faces + hn::MaxLanes(half) / 4, place),
                           CornerAt(half, seen, faces, place));
    }
}

template <class D>
HWY_INLINE Bits BitsOf(D d, hn::Mask<D> mask) {
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(d, mask, bytes);
    static_assert(std::endian::native == std::endian::little);
    std::uint16_t bits = 0;
    std::memcpy(&bits, bytes, sizeof(bits));
    return bits;
}

/// What corners have in common.
template <class D>
struct Common {
    hn::Vec<D> least, most, all, any;
};

template <class D>
HWY_INLINE void Add(hn::Vec<D> corner, Common<D>& common) {
    common.least = hn::Min(common.least, corner);
    common.most = hn::Max(common.most, corner);
    common.all = hn::And(common.all, corner);
    common.any = hn::Or(common.any, corner);
}

/// Twice the signed areas, in (element, line), between sides of (line, element).
template <class V>
HWY_INLINE auto Areas(V from, V to) {
    return hn::Sub(hn::MulEven(hn::Shuffle2301(from), to), hn::MulEven(from, hn::Shuffle2301(to)));
}

/// Bits 1 and 3 of each face: is the area of the first, or of the second triangle that fans out from its first corner that of a
/// front?
template <class D, class V = hn::Vec<D>>
HWY_INLINE Bits FrontBits(D d, bool vertical, V first, V second, V third, V fourth) {
    const hn::RepartitionToWide<D> pairs;
    const auto side = [&](V corner) HWY_ATTR { return hn::BitCast(pairs, hn::Sub(corner, first)); };
    const auto from = hn::BitCast(d, hn::InterleaveLower(pairs, side(second), side(third)));
    const auto to = hn::BitCast(d, hn::InterleaveLower(pairs, side(third), side(fourth)));
    const auto areas = vertical ? Areas(to, from) : Areas(from, to);
    return BitsOf(d, hn::Lt(hn::BitCast(d, areas), hn::Zero(d)));
}

/// What there is to know of faces side by side, at the lowest bit of each. `hidden` and `front` count for whole ones alone.
struct Judgement {
    Bits whole = 0;   ///< in front of the near plane and inside the guard band
    Bits level = 0;   ///< of one intensity
    Bits in_view = 0; ///< not all corners outside one side of the frustum
    Bits hidden = 0;  ///< beside the picture, or between two lines' centres
    Bits front = 0;   ///< a triangle of it shows its front: if none does, nor does the whole
};

/// What lanes are held against, four of each, set before many faces are judged.
struct Limits {
    explicit Limits(const FaceSieve& sieve)
        : end{sieve.last_line - 1, sieve.last_element - 1, std::numeric_limits<std::int32_t>::max(), 0},
          never{sieve.low_faces ? 1 : 0, 1, 0, 0}, vertical(sieve.vertical) {}
    alignas(16) std::int32_t end[4];
    alignas(16) std::int32_t never[4];
    alignas(16) std::int32_t begin[4] = {1, 1, -1, -1};
    alignas(16) std::int32_t place[4] = {-1, -1, -1, 0};
    alignas(16) std::int32_t line[4] = {-1, 0, 0, 0};
    alignas(16) std::int32_t intensity[4] = {0, 0, -1, 0};
    alignas(16) std::int32_t cut[4] = {0, 0, 0, before_near | guard};
    alignas(16) std::int32_t frustum[4] = {0, 0, 0, frustum_sides};
    bool vertical; ///< lines are columns
};

/// Faces of at most four corners; or one of any number, of which `front` is not known if they are more.
template <class D>
HWY_INLINE Judgement Judge(D d, const Limits& limits, const SeenVertex* seen, const FaceCorners* faces) {
    const auto constant = [&](const std::int32_t* of) HWY_ATTR { return hn::LoadDup128(d, of); };
    const auto first = CornerAt(d, seen, faces, Place::first);
    const auto second = CornerAt(d, seen, faces, Place::second);
    const auto third = CornerAt(d, seen, faces, Place::third);
    const auto fourth = CornerAt(d, seen, faces, Place::last);
    Common<D> common{hn::Min(hn::Min(first, second), hn::Min(third, fourth)),
                     hn::Max(hn::Max(first, second), hn::Max(third, fourth)),
                     hn::And(hn::And(first, second), hn::And(third, fourth)),
                     hn::Or(hn::Or(first, second), hn::Or(third, fourth))};
    if constexpr (hn::MaxLanes(d) == 4)
        for (std::uint32_t k = 3; k + 1 < faces->count; ++k)
            Add<D>(hn::Load(d, &seen[faces->index[k]].snapped.line), common);

    // Lanes that are zero: the line, if no line's centre lies between; the intensity, if there is one; outside, if in view.
    const auto line_at = [&](hn::Vec<D> v)
                             HWY_ATTR { return hn::ShiftRight<8>(hn::Add(v, hn::Set(d, 127))); };
    const auto crossed = hn::And(hn::Xor(line_at(common.least), line_at(common.most)), constant(limits.line));
    const auto uneven = hn::And(hn::Xor(common.least, common.most), constant(limits.intensity));
    const auto outside = hn::And(common.all, constant(limits.frustum));
    const auto some = hn::Or(hn::Or(crossed, uneven), hn::Or(outside, constant(limits.never)));
    const Bits none_of = BitsOf(d, hn::Eq(some, hn::Zero(d)));
    // Lanes that lie beyond: line and element beside the picture; outside, if something cuts the face.
    const auto cut = hn::And(common.any, constant(limits.cut));
    const auto beyond =
        hn::Or(hn::Gt(hn::Or(hn::And(common.least, constant(limits.place)), cut), constant(limits.end)),
               hn::Gt(constant(limits.begin), common.most));
    const Bits beside = BitsOf(d, beyond);
    const Bits front = FrontBits(d, limits.vertical, first, second, third, fourth);
    return {.whole = ~(beside >> 3U) & each,
            .level = none_of >> 2U & each,
            .in_view = none_of >> 3U & each,
            .hidden = (none_of | beside | beside >> 1U) & each,
            .front = (front >> 1U | front >> 3U) & each};
}

/// Those of `count` faces side by side that stay; `any_side`: of which it does not matter where their front is.
HWY_INLINE SiftedFace* Leave(const Judgement& found, Bits any_side, std::uint32_t first, std::uint32_t count,
                             SiftedFace* left) {
    const Bits stays = found.in_view & (~found.whole | (~found.hidden & (found.front | any_side)));
    const Bits marks = found.whole * SiftedFace::whole_mark | found.level * SiftedFace::level_mark;
    for (std::uint32_t k = 0; k < count; ++k) {
        *left = {first + k, marks >> 4 * k};
        left += stays >> 4 * k & 1U;
    }
    return left;
}

bool SiftFaces(const FaceSieve& sieve, const FaceBlock& block, const SeenVertex* seen, std::uint32_t first,
               std::uint32_t count, SiftedFaces& left) {
    const Limits limits(sieve);
    const std::uint32_t* const corners = block.corners.data();
    SiftedFace* out = left.faces.data();
    const auto one_by_one = [&](std::uint32_t from, std::uint32_t end) HWY_ATTR {
        for (std::uint32_t f = from; f < end; ++f) {
            const Face& face = block.faces[f];
            const FaceCorners of_face{corners + face.first_corner, face.corner_count};
            const Bits any_side = face.two_sided != 0 || face.corner_count > 4 ? 1 : 0;
            out = Leave(Judge(One(), limits, seen, &of_face), any_side, f, 1, out);
        }
    };
    std::uint32_t f = first;
    for (; f + at_once <= first + count; f += at_once) {
        FaceCorners faces[at_once];
        Bits any_side = 0;
        std::uint32_t most = 0;
        for (std::uint32_t k = 0; k < at_once; ++k) {
            const Face& face = block.faces[f + k];
            faces[k] = {corners + face.first_corner, face.corner_count};
            any_side |= static_cast<Bits>(face.two_sided != 0 ? 1 : 0) << 4 * k;
            most = std::max<std::uint32_t>(most, face.corner_count);
        }
        if (most > 4)
            one_by_one(f, f + at_once);
        else
            out = Leave(Judge(Wide(), limits, seen, faces), any_side, f, at_once, out);
    }
    one_by_one(f, first + count);
    left.count = static_cast<std::uint32_t>(out - left.faces.data());
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
