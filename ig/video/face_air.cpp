#ifndef LINKDIG_FACE_AIR_ONCE
#define LINKDIG_FACE_AIR_ONCE
#include "ig/video/face_air.h"

#include "ig/floor.h"
#include "ig/simd/simd_level.h"
#include "ig/video/inverse_range.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace linkdig::ig {
namespace {

constexpr double one_over_e = 0.36787944117144232;

/// A face's box in the raster: its middle pixel, and how far the others are from that at most.
struct Box {
    std::int32_t line = 0;
    std::int32_t element = 0;
    std::int32_t lines = 0;
    std::int32_t elements = 0;
};

Box box_of(const EdgeFace& face) {
    return {(face.first_line + face.end_line) / 2, (face.first_element + face.end_element) / 2,
            std::max((face.end_line - face.first_line + 1) / 2, 1),
            std::max((face.end_element - face.first_element + 1) / 2, 1)};
}

/// A plane of transmission through the value at the box's middle.
FaceAir planar(const Box& box, std::int32_t value, std::int32_t along, std::int32_t across) {
    return {{box.line, box.element, static_cast<std::uint32_t>(value), static_cast<std::uint32_t>(along),
             static_cast<std::uint32_t>(across), 0, intensity_one},
            AirKind::plane};
}

/// Of a face whose transmission is no plane: flat, or taken pixel by pixel.
FaceAir flat_or_by_pixel(const DepthPlane& depth, const Air& air, const Box& box) {
    std::int32_t transmission = 0;
    if (!air.is_flat(depth, transmission)) return {.transmission = {}, .kind = AirKind::by_pixel};
    return planar(box, transmission << 7, 0, 0);
}

/// What is worked out for several faces at once; rows of lanes.
struct Planes {
    static constexpr std::size_t room = 8;
    template <typename T>
    using Row = std::array<T, room>;
    alignas(64) Row<double> inverse, across, along;                 ///< of DepthPlane
    alignas(64) Row<double> line, element, lines, elements;         ///< of Box
    alignas(64) Row<std::int32_t> value, value_along, value_across; ///< of the transmission, 1.0 = 2^22
    alignas(64) Row<std::int64_t> fits;                             ///< not 0: its transmission is a plane
};

/// One of them, plainly: the reference for the vectors, which do the same step by step.
///
/// From the middle of the box to any of its pixels the range x (in units over which 1/e is left) changes by a part g of itself at
/// most, h of it by 1/z and the rest by the ray's length. It curves by 2 h^2 of itself by 1/z, and by the square of the ray's turn.
/// So t = exp(-x) is off the plane that touches it in the middle by no more than half of 2 x t (g^2 + turn^2 / 2), where x t is
/// under x, and under 1/e.
void work_out_plainly(const Air& air, Planes& p, std::size_t k) {
    const AirRays& rays = air.ray_slopes();
    const double middle = (p.inverse[k] + p.line[k] * p.across[k]) + p.element[k] * p.along[k];
    const double reach = std::fabs(p.along[k]) * p.elements[k] + std::fabs(p.across[k]) * p.lines[k];
    const double least = middle - reach;
    const double along_ray = rays.element_start + rays.element_slope * p.element[k];
    const double across_ray = rays.line_start + rays.line_slope * p.line[k];
    const double ray = std::sqrt((1.0 + along_ray * along_ray) + across_ray * across_ray);
    const double turn_along = std::fabs(rays.element_slope) * p.elements[k];
    const double turn_across = std::fabs(rays.line_slope) * p.lines[k];
    const double turn = turn_along + turn_across;
    const double lengthens = std::fabs(along_ray) * turn_along + std::fabs(across_ray) * turn_across;
    const double changes = reach / least + (lengthens + turn * turn);
    const double farthest = (ray + turn) * (natural_logarithm_of_2 / air.m_per_octave()) / least;
    const double curves = std::min(farthest, one_over_e) * (changes * changes + turn * turn * 0.5);
    const bool fits = least > 0.0 && curves <= planar_error;

    const double inverse = fits ? middle : 1.0;
    const double octaves = std::min(ray / (inverse * air.m_per_octave()), double{most_octaves});
    const double scaled = static_cast<double>(light_left(static_cast<float>(octaves))) * intensity_one;
    const double steepness = scaled * octaves * -natural_logarithm_of_2;
    const double grows_along = along_ray * rays.element_slope / (ray * ray) - p.along[k] / inverse;
    const double grows_across = across_ray * rays.line_slope / (ray * ray) - p.across[k] / inverse;
    p.fits[k] = fits ? 1 : 0;
    p.value[k] = static_cast<std::int32_t>(floor_of(scaled + 0.5));
    p.value_along[k] = fits ? static_cast<std::int32_t>(floor_of(steepness * grows_along + 0.5)) : 0;
    p.value_across[k] = fits ? static_cast<std::int32_t>(floor_of(steepness * grows_across + 0.5)) : 0;
}

/// Takes in what is known of a face.
void put(const DepthPlane& depth, const Box& box, Planes& p, std::size_t k) {
    p.inverse[k] = depth.inverse_m;
    p.across[k] = depth.across;
    p.along[k] = depth.along;
    p.line[k] = box.line;
    p.element[k] = box.element;
    p.lines[k] = box.lines;
    p.elements[k] = box.elements;
}

/// Faces in groups; `work_out` is given each group and how many are in it.
template <typename WorkOut>
[[gnu::always_inline]] inline void judge(const ProjectedFaces& projected, const FaceEdges& edges,
                                         const Air& air, std::vector<FaceAir>& face_air, WorkOut work_out) {
    Planes planes{};
    for (std::size_t rank = 0; rank < face_air.size();) {
        std::array<std::size_t, Planes::room> ranks{};
        std::size_t count = 0;
        for (; rank < face_air.size() && count < Planes::room; ++rank) {
            const std::int32_t depth = projected.faces[rank].depth;
            face_air[rank].kind = AirKind::clear;
            if (depth < 0) continue;
            ranks[count] = rank;
            put(projected.depths[static_cast<std::size_t>(depth)], box_of(edges.faces[rank]), planes,
                count++);
        }
        work_out(planes, count);
        for (std::size_t k = 0; k < count; ++k) {
            const Box box = box_of(edges.faces[ranks[k]]);
            const auto depth = static_cast<std::size_t>(projected.faces[ranks[k]].depth);
            face_air[ranks[k]] = planes.fits[k] != 0 ? planar(box, planes.value[k], planes.value_along[k],
                                                              planes.value_across[k])
                                                     : flat_or_by_pixel(projected.depths[depth], air, box);
        }
    }
}

} // namespace
} // namespace linkdig::ig
#endif

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "ig/video/face_air.cpp"
#include <hwy/foreach_target.h> // compiles this file once for every SIMD level
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace linkdig::ig {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using F64 = hn::CappedTag<double, Planes::room>;
using I64 = hn::Repartition<std::int64_t, F64>;
using F32 = hn::Rebind<float, F64>;
using I32 = hn::Rebind<std::int32_t, F64>;
using V = hn::Vec<F64>;

HWY_INLINE V Set(double value) { return hn::Set(F64(), value); }
HWY_INLINE V Load(const Planes::Row<double>& row, std::size_t k) { return hn::Load(F64(), row.data() + k); }

/// As light_left().
HWY_INLINE V LightLeft(V octaves) {
    const F32 d;
    const auto o = hn::DemoteTo(d, octaves);
    const auto whole = hn::ConvertTo(I32(), o);
    const auto part = hn::Sub(o, hn::ConvertTo(d, whole));
    auto power = hn::Set(d, falling_octave[4]);
    for (int c = 3; c >= 0; --c)
        power = hn::Add(hn::Mul(power, part), hn::Set(d, falling_octave[static_cast<std::size_t>(c)]));
    return hn::PromoteTo(F64(), hn::BitCast(d, hn::Sub(hn::BitCast(I32(), power), hn::ShiftLeft<23>(whole))));
}

/// As floor(value + 0.5).
HWY_INLINE void StoreRounded(V value, Planes::Row<std::int32_t>& row, std::size_t k) {
    hn::Store(hn::DemoteTo(I32(), hn::Floor(hn::Add(value, Set(0.5)))), I32(), row.data() + k);
}

/// As work_out_plainly().
HWY_INLINE void WorkOut(const AirRays& rays, double m_per_octave, Planes& p, std::size_t k) {
    const auto along = Load(p.along, k), across = Load(p.across, k);
    const auto element = Load(p.element, k), line = Load(p.line, k);
    const auto elements = Load(p.elements, k), lines = Load(p.lines, k);
    const auto middle = hn::Add(hn::Add(Load(p.inverse, k), hn::Mul(line, across)), hn::Mul(element, along));
    const auto reach = hn::Add(hn::Mul(hn::Abs(along), elements), hn::Mul(hn::Abs(across), lines));
    const auto least = hn::Sub(middle, reach);
    const auto along_ray = hn::Add(Set(rays.element_start), hn::Mul(Set(rays.element_slope), element));
    const auto across_ray = hn::Add(Set(rays.line_start), hn::Mul(Set(rays.line_slope), line));
    const auto ray =
        hn::Sqrt(hn::Add(hn::Add(Set(1.0), hn::Mul(along_ray, along_ray)), hn::Mul(across_ray, across_ray)));
    const auto turn_along = hn::Mul(Set(std::fabs(rays.element_slope)), elements);
    const auto turn_across = hn::Mul(Set(std::fabs(rays.line_slope)), lines);
    const auto turn = hn::Add(turn_along, turn_across);
    const auto lengthens =
        hn::Add(hn::Mul(hn::Abs(along_ray), turn_along), hn::Mul(hn::Abs(across_ray), turn_across));
    const auto changes = hn::Add(hn::Div(reach, least), hn::Add(lengthens, hn::Mul(turn, turn)));
    const auto farthest =
        hn::Div(hn::Mul(hn::Add(ray, turn), Set(natural_logarithm_of_2 / m_per_octave)), least);
    const auto curves = hn::Mul(hn::Min(farthest, Set(one_over_e)),
                                hn::Add(hn::Mul(changes, changes), hn::Mul(hn::Mul(turn, turn), Set(0.5))));
    const auto fits = hn::And(hn::Gt(least, Set(0.0)), hn::Le(curves, Set(planar_error)));

    const auto inverse = hn::IfThenElse(fits, middle, Set(1.0));
    const auto octaves =
        hn::Min(hn::Div(ray, hn::Mul(inverse, Set(m_per_octave))), Set(double{most_octaves}));
    const auto scaled = hn::Mul(LightLeft(octaves), Set(intensity_one));
    const auto steepness = hn::Mul(hn::Mul(scaled, octaves), Set(-natural_logarithm_of_2));
    const auto square = hn::Mul(ray, ray);
    const auto grows_along =
        hn::Sub(hn::Div(hn::Mul(along_ray, Set(rays.element_slope)), square), hn::Div(along, inverse));
    const auto grows_across =
        hn::Sub(hn::Div(hn::Mul(across_ray, Set(rays.line_slope)), square), hn::Div(across, inverse));
    hn::Store(hn::IfThenElseZero(hn::RebindMask(I64(), fits), hn::Set(I64(), 1)), I64(), p.fits.data() + k);
    StoreRounded(scaled, p.value, k);
    StoreRounded(hn::IfThenElseZero(fits, hn::Mul(steepness, grows_along)), p.value_along, k);
    StoreRounded(hn::IfThenElseZero(fits, hn::Mul(steepness, grows_across)), p.value_across, k);
}

void JudgeAir(const ProjectedFaces& projected, const FaceEdges& edges, const Air& air,
              std::vector<FaceAir>& face_air) {
    const AirRays rays = air.ray_slopes();
    const double m_per_octave = air.m_per_octave();
    judge(projected, edges, air, face_air, [&](Planes& planes, std::size_t count) HWY_ATTR {
        for (std::size_t k = 0; k < count; k += hn::Lanes(F64()))
            WorkOut(rays, m_per_octave, planes, k);
    });
}

} // namespace HWY_NAMESPACE
} // namespace linkdig::ig
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace linkdig::ig {

namespace {

HWY_EXPORT(JudgeAir);

} // namespace

void judge_air(const ProjectedFaces& projected, const FaceEdges& edges, const Air& air,
               std::vector<FaceAir>& face_air) {
    face_air.resize(air.clear() ? 0 : projected.faces.size());
    if (simd_is_off()) {
        judge(projected, edges, air, face_air, [&](Planes& planes, std::size_t count) {
            for (std::size_t k = 0; k < count; ++k)
                work_out_plainly(air, planes, k);
        });
    } else {
        HWY_DYNAMIC_DISPATCH(JudgeAir)(projected, edges, air, face_air);
    }
}

std::int32_t transmission_of(const FaceAir& face_air, const DepthPlane& depth, const Air& air,
                             std::int32_t line, std::int32_t element) {
    if (face_air.kind == AirKind::by_pixel) return transmission_of(depth, air, line, element);
    return planar_transmission(face_air.transmission, line, element);
}

} // namespace linkdig::ig
#endif
