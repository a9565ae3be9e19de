#include "ig/lights/splat.h"

#include <algorithm>

namespace linkdig::ig {

namespace {

class SplatMaker {
public:
    SplatMaker(const Raster& raster, std::uint32_t lines_per_band, Splats& splats)
        : lines_(static_cast<std::int32_t>(raster.lines())),
          elements_(static_cast<std::int32_t>(raster.elements())),
          lines_per_band_(static_cast<std::int32_t>(lines_per_band)), out_(splats) {}

    void put(const ProjectedLight& light, std::uint32_t index) {
        weigh(light);
        const std::uint64_t sum = out_.running.back();
        std::int32_t band = -1;
        std::size_t k = 0;
        std::uint64_t before = 0;
        for (std::int32_t line = first_line_; line <= last_line_; ++line) {
            for (std::int32_t element = first_element_; element <= last_element_; ++element, ++k) {
                const std::uint64_t upto = out_.running[k] * whole_splat / sum;
                const auto weight = static_cast<std::uint32_t>(upto - before);
                before = upto;
                if (weight == 0 || line < 0 || line >= lines_ || element < 0 || element >= elements_)
                    continue;
                if (line / lines_per_band_ != band) open(light, index, band = line / lines_per_band_);
                out_.pixels.push_back(
                    {static_cast<std::uint16_t>(line), static_cast<std::uint16_t>(element), weight});
                ++out_.unsorted.back().pixel_count;
            }
        }
    }

private:
    /// Running sums of the bump over the square of pixels about the light.
    void weigh(const ProjectedLight& light) {
        first_line_ = (light.at.line - light.radius) >> 8;
        last_line_ = (light.at.line + light.radius) >> 8;
        first_element_ = (light.at.element - light.radius) >> 8;
        last_element_ = (light.at.element + light.radius) >> 8;
        const std::int64_t square = std::int64_t{light.radius} * light.radius;
        std::uint64_t sum = 0;
        out_.running.clear();
        for (std::int32_t line = first_line_; line <= last_line_; ++line) {
            const std::int64_t down = 256LL * line + 128 - light.at.line;
            for (std::int32_t element = first_element_; element <= last_element_; ++element) {
                const std::int64_t right = 256LL * element + 128 - light.at.element;
                const std::int64_t inside = std::max<std::int64_t>(0, square - down * down - right * right);
                sum += static_cast<std::uint64_t>(inside * inside) >> 16U; // at most 2^32, 1089 times
                out_.running.push_back(sum);
            }
        }
    }

    void open(const ProjectedLight& light, std::uint32_t index, std::int32_t band) {
        out_.unsorted.push_back({light.rank, index, static_cast<std::uint32_t>(out_.pixels.size()), 0});
        out_.band_of.push_back(static_cast<std::uint32_t>(band));
    }

    std::int32_t lines_;
    std::int32_t elements_;
    std::int32_t lines_per_band_;
    Splats& out_;
    std::int32_t first_line_ = 0, last_line_ = 0, first_element_ = 0, last_element_ = 0;
};

/// Counting sort: keeps the order within a band.
void sort_by_band(std::uint32_t bands, Splats& splats) {
    splats.first.assign(bands + 1, 0);
    for (const std::uint32_t band : splats.band_of)
        ++splats.first[band + 1];
    for (std::uint32_t band = 0; band < bands; ++band)
        splats.first[band + 1] += splats.first[band];
    splats.lights.resize(splats.unsorted.size());
    for (std::size_t k = 0; k < splats.unsorted.size(); ++k)
        splats.lights[splats.first[splats.band_of[k]]++] = splats.unsorted[k];
    for (std::uint32_t band = bands; band > 0; --band)
        splats.first[band] = splats.first[band - 1];
    splats.first[0] = 0;
}

} // namespace

void make_splats(std::span<const ProjectedLight> lights, const Raster& raster, std::uint32_t lines_per_band,
                 Splats& splats) {
    splats.pixels.clear();
    splats.unsorted.clear();
    splats.band_of.clear();
    SplatMaker maker(raster, lines_per_band, splats);
    for (std::size_t k = 0; k < lights.size(); ++k)
        maker.put(lights[k], static_cast<std::uint32_t>(k));
    sort_by_band((raster.lines() + lines_per_band - 1) / lines_per_band, splats);
}

} // namespace linkdig::ig
