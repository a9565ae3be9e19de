#include "ig/video/colour_run.h"

#include "ig/edges/edges.h"

namespace linkdig::ig {

namespace {

/// With 15 bits, as a scale of colour codes.
std::uint32_t scale_of(std::int32_t intensity) {
    const std::uint32_t i = static_cast<std::uint32_t>(intensity) >> 7U;
    return i > 32767U ? 32767U : i;
}

} // namespace

Tint tint_at(const IntensityPlane* planes, std::int32_t line, std::int32_t element) {
    return {intensity_at(planes[0], line, element), intensity_at(planes[1], line, element),
            intensity_at(planes[2], line, element)};
}

Components lit(const Tint& tint) {
    const auto times = [](std::int32_t intensity) {
        return ((255U << 7U) * scale_of(intensity) + (1U << 14U)) >> 15U;
    };
    return {times(tint[0]), times(tint[1]), times(tint[2])};
}

std::uint32_t shade(const Tint& tint) {
    const auto level = [](std::int32_t intensity) {
        return (255U * scale_of(intensity) + (1U << 14U)) >> 15U;
    };
    return level(tint[0]) | level(tint[1]) << 8U | level(tint[2]) << 16U | 0xff000000U;
}

void colour_run(const IntensityPlane* planes, std::int32_t line, std::int32_t element, std::uint32_t count,
                std::uint32_t* pixels) {
    for (std::uint32_t k = 0; k < count; ++k)
        pixels[k] = shade(tint_at(planes, line, element + static_cast<std::int32_t>(k)));
}

void colour_run_in_air(const IntensityPlane* planes, const FaceAir& face_air, const DepthPlane& depth,
                       const Air& air, std::int32_t line, std::int32_t element, std::uint32_t count,
                       std::uint32_t* pixels) {
    for (std::uint32_t k = 0; k < count; ++k) {
        const std::int32_t at = element + static_cast<std::int32_t>(k);
        const std::int32_t t = transmission_of(face_air, depth, air, line, at);
        const Components seen = through_air(lit(tint_at(planes, line, at)), t, air.horizon());
        pixels[k] = (seen.red + 64U) >> 7U | (seen.green + 64U) >> 7U << 8U | (seen.blue + 64U) >> 7U << 16U |
                    0xff000000U;
    }
}

} // namespace linkdig::ig
