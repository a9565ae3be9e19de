#pragma once
/// What both second opinions need to know of a picture: the layout of its planes and how a colour code is
/// shaded. Written from the contracts (ig/video/line.h, ig/geometry/projected_face.h), without a line of the
/// machine.

#include "database/model/visual_database.h"
#include "ig/configuration.h"
#include "ig/geometry/projected_face.h"
#include "ig/video/line.h"

#include <cstddef>
#include <cstdint>

namespace linkdig::support {

/// Integers wide enough for the exact comparison of any crossing.
__extension__ using Wide = __int128;

/// Centre of line or element n, in 1/256 pixel.
constexpr std::int64_t centre_of(std::int64_t n) { return n * ig::subpixels + ig::subpixels / 2; }

/// Place of (line, element) in the planes of a VideoFrame: row by row as the viewer sees them, whatever the
/// scan.
inline std::size_t place(const ig::Raster& raster, std::uint32_t line, std::uint32_t element) {
    const std::uint32_t row = raster.scan == ig::Scan::horizontal ? line : element;
    const std::uint32_t column = raster.scan == ig::Scan::horizontal ? element : line;
    return std::size_t{row} * raster.width + column;
}

/// 0xAABBGGRR, opaque.
constexpr std::uint32_t packed(std::uint32_t red, std::uint32_t green, std::uint32_t blue) {
    return 0xff000000U | blue << 16U | green << 8U | red;
}

/// Colour code x intensity (1.0 = 2^22), rounded per component: what the pixel ought to be.
constexpr std::uint32_t shaded(const Colour& colour, std::int32_t intensity) {
    const auto component = [intensity](std::uint8_t code) {
        return static_cast<std::uint32_t>((std::int64_t{code} * intensity + (1 << 21)) >> 22);
    };
    return packed(component(colour.red), component(colour.green), component(colour.blue));
}

/// The same as ig/video/pixel_run.h specifies it: the intensity takes part with 15 bits, at most 32767 of
/// them, and the product is rounded once.
constexpr std::uint32_t shaded_with_15_bits(const Colour& colour, std::int32_t intensity) {
    const std::int64_t scale = intensity / 128 < 32767 ? intensity / 128 : 32767;
    const auto component = [scale](std::uint8_t code) {
        return static_cast<std::uint32_t>((code * scale + 16384) / 32768);
    };
    return packed(component(colour.red), component(colour.green), component(colour.blue));
}

/// A frame with all planes, where only the background is seen.
inline ig::VideoFrame empty_picture(const ig::Raster& raster, std::uint32_t background) {
    const std::size_t size = std::size_t{raster.width} * raster.height;
    ig::VideoFrame frame;
    frame.width = raster.width;
    frame.height = raster.height;
    frame.pixels.assign(size, background);
    frame.intensity.assign(size, none);
    frame.rank.assign(size, none);
    return frame;
}

} // namespace linkdig::support
