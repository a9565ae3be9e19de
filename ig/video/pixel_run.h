#pragma once
/// Consecutive pixels of one smooth-shaded face: the machine's inner loop, once for every SIMD level.
///
/// Only integers, so every level gives the same bytes: SSE2 to AVX-512 are chosen at run time, plain C++ is
/// always there.

#include "database/model/visual_database.h"
#include "ig/edges/edge.h"
#include "ig/scanline/segment.h"
#include "ig/video/face_air.h"
#include "ig/video/fog.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace linkdig::ig {

/// A colour code at an intensity (1.0 = 2^22): each component x intensity, rounded once to the nearest level.
/// The intensity takes part with 15 bits, which moves the product by less than 1/128 level.
inline std::uint32_t shade(Colour colour, std::int32_t intensity) {
    const std::uint32_t i = static_cast<std::uint32_t>(intensity) >> 7U;
    const std::uint32_t scale = i > 32767U ? 32767U : i;
    constexpr std::uint32_t half = 1U << 14U;
    return ((colour.red * scale + half) >> 15U) | ((colour.green * scale + half) >> 15U) << 8U |
           ((colour.blue * scale + half) >> 15U) << 16U | 0xff000000U;
}

/// Where the elements of a band stand in memory.
struct BandPixels {
    std::uint32_t* start = nullptr;
    std::uint32_t first_line = 0;
    std::uint32_t length = 0; ///< of a line, elements
    /// Long runs are written past the caches: before the picture is read the band must be settled (settle_pixels()).
    bool past_caches = false;

    std::uint32_t* at(std::uint32_t line, std::uint32_t element) const {
        return start + std::size_t{line - first_line} * length + element;
    }
    std::uint32_t* at(const Segment& segment) const { return at(segment.line, segment.first); }
};

/// What was written past the caches is seen by whoever comes after.
void settle_pixels(const BandPixels& pixels);

/// Gives all pixels of the runs this value.
void fill_runs(std::uint32_t pixel, std::span<const Segment> runs, const BandPixels& pixels);

/// Faces of a band, and what colours them.
struct BandFaces {
    std::span<const FaceSegments> faces;
    std::span<const Segment> segments; ///< of all of them
    std::span<const FaceShading> shadings;
    std::span<const Colour> colours;
    std::span<const FaceAir> air; ///< none: no air plays a part
    Colour horizon;
};

/// Shades faces from number `from` on, until one comes that has more than one colour code, or air that is taken pixel by pixel.
/// Returns the number of that one, or of faces.
std::size_t shade_faces(const BandFaces& faces, std::size_t from, const BandPixels& pixels);

/// A colour before it is rounded to levels: components with 7 fraction bits, 0 to 255 * 128.
struct Components {
    std::uint32_t red = 0, green = 0, blue = 0;
};

inline Components lit(Colour colour, std::int32_t intensity) {
    const std::uint32_t i = static_cast<std::uint32_t>(intensity) >> 7U;
    const std::uint32_t scale = i > 32767U ? 32767U : i;
    const auto times = [scale](std::uint32_t code) { return ((code << 7U) * scale + (1U << 14U)) >> 15U; };
    return {times(colour.red), times(colour.green), times(colour.blue)};
}

/// Seen through air of a transmission (1.0 = 32767).
inline Components through_air(const Components& face, std::int32_t transmission, Colour horizon) {
    const auto mix = [transmission](std::uint32_t component, std::uint8_t horizon_code) {
        const std::int32_t air = std::int32_t{horizon_code} << 7;
        const std::int32_t left = (static_cast<std::int32_t>(component) - air) * transmission;
        return static_cast<std::uint32_t>(air + ((left + (1 << 14)) >> 15));
    };
    return {mix(face.red, horizon.red), mix(face.green, horizon.green), mix(face.blue, horizon.blue)};
}

/// A pixel of a face seen through air, rounded to levels.
inline std::uint32_t shade_through_air(Colour colour, std::int32_t intensity, std::int32_t transmission,
                                       Colour horizon) {
    const Components seen = through_air(lit(colour, intensity), transmission, horizon);
    return (seen.red + 64U) >> 7U | (seen.green + 64U) >> 7U << 8U | (seen.blue + 64U) >> 7U << 16U |
           0xff000000U;
}

/// Shades runs of one face whose range is taken at every pixel, or every few where it changes little (air_samples.h).
void shade_runs_in_air(const IntensityPlane& plane, Colour colour, const DepthPlane& depth, const Air& air,
                       std::span<const Segment> runs, const BandPixels& pixels);

} // namespace linkdig::ig
