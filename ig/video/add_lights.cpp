#include "ig/video/add_lights.h"

#include "ig/lights/splat.h"

#include <algorithm>

namespace linkdig::ig {

namespace {

constexpr std::uint32_t brightest = 255U << 7U; ///< of Components

/// code (8 bits) * total (24 bits, 8 of fraction) * weight (16 of fraction), to 7 of fraction.
std::uint32_t part(std::uint32_t code, std::uint32_t total, std::uint32_t weight) {
    constexpr std::uint64_t half = 1U << 16U;
    const std::uint64_t light = (std::uint64_t{code} * total * weight + half) >> 17U;
    return static_cast<std::uint32_t>(std::min<std::uint64_t>(light, brightest));
}

void add(std::uint32_t& sum, std::uint32_t light) { sum = std::min(sum + light, brightest); }

std::uint32_t brightened(std::uint32_t pixel, const Components& light) {
    const auto component = [pixel](std::uint32_t shift, std::uint32_t sum) {
        return std::min(255U, (pixel >> shift & 0xffU) + ((sum + 64U) >> 7U)) << shift;
    };
    return component(0, light.red) | component(8, light.green) | component(16, light.blue) | 0xff000000U;
}

} // namespace

std::uint64_t add_lights(std::span<const ProjectedLight> lights, std::span<const Colour> colours,
                         const Raster& raster, const BandSegments& band, LightSums& sums, VideoFrame& frame) {
    if (band.lights.empty()) return 0;
    const std::uint32_t elements = raster.elements();
    sums.of_pixel.resize(std::size_t{band_lines} * elements);
    sums.touched.clear();
    for (const LightPixel& pixel : band.lights) {
        const ProjectedLight& light = lights[pixel.light];
        const Colour colour = colours[light.colour];
        const std::uint32_t at = (pixel.line - band.first_line) * elements + pixel.element;
        Components& sum = sums.of_pixel[at];
        if ((sum.red | sum.green | sum.blue) == 0) sums.touched.push_back(at);
        add(sum.red, part(colour.red, light.total, pixel.weight));
        add(sum.green, part(colour.green, light.total, pixel.weight));
        add(sum.blue, part(colour.blue, light.total, pixel.weight));
    }
    const bool horizontal = raster.scan == Scan::horizontal;
    std::uint64_t pixels = 0;
    for (const std::uint32_t at : sums.touched) {
        Components& sum = sums.of_pixel[at];
        if ((sum.red | sum.green | sum.blue) == 0) continue; // listed twice: too dim for one unit at first
        const std::size_t line = band.first_line + at / elements;
        const std::size_t element = at % elements;
        std::uint32_t& shown =
            frame.pixels[horizontal ? line * raster.width + element : element * raster.width + line];
        shown = brightened(shown, sum);
        sum = {};
        ++pixels;
    }
    return pixels;
}

} // namespace linkdig::ig
