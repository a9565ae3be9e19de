#include "ig/video/fog.h"

#include "database/model/mathematics.h"

#include <algorithm>
#include <cmath>

namespace linkdig::ig {

namespace {

std::vector<std::int32_t> make_transmission() {
    std::vector<std::int32_t> table(transmission_entries);
    for (std::int32_t k = 0; k < transmission_entries; ++k) {
        table[static_cast<std::size_t>(k)] =
            static_cast<std::int32_t>(exponential(-k / steps_per_optical_depth) * transmission_one + 0.5);
    }
    table.back() = 0; // everything beyond, too
    return table;
}

} // namespace

void Air::prepare(const PictureScale& scale, const Raster& raster, double visibility_m, Colour horizon) {
    visibility_m_ = visibility_m;
    horizon_ = horizon;
    if (clear()) return;
    if (transmission_.empty()) transmission_ = make_transmission();
    steps_per_m_ = static_cast<float>(extinction_at_visibility * steps_per_optical_depth / visibility_m);
    make_rays(scale, raster);
}

void Air::make_rays(const PictureScale& scale, const Raster& raster) {
    if (scale == made_for_ && raster == made_raster_) return;
    made_for_ = scale;
    made_raster_ = raster;
    elements_ = raster.elements();
    const bool vertical = raster.scan == Scan::vertical;
    rays_.resize(std::size_t{raster.width} * raster.height + rays_padding, 1.0F);
    for (std::uint32_t line = 0; line < raster.lines(); ++line) {
        for (std::uint32_t element = 0; element < elements_; ++element) {
            const double column = 256.0 * (vertical ? line : element) + 128.0;
            const double row = 256.0 * (vertical ? element : line) + 128.0;
            const double tx = (column - scale.x_offset) / scale.x_scale;
            const double ty = (row - scale.y_offset) / scale.y_scale;
            rays_[std::size_t{line} * elements_ + element] =
                static_cast<float>(std::sqrt(1.0 + tx * tx + ty * ty));
        }
    }
}

std::int32_t Air::transmission_at(double range_m) const {
    const double step =
        std::min(range_m * static_cast<double>(steps_per_m_) + 0.5, transmission_entries - 1.0);
    return transmission_[static_cast<std::size_t>(step)];
}

bool Air::is_flat(const DepthPlane& depth, std::int32_t& transmission) const {
    const std::int32_t greatest = transmission_at(depth.nearest_m);
    const std::int32_t least = transmission_at(depth.farthest_m);
    transmission = (greatest + least) / 2;
    return greatest - least <= transmission_one / 255;
}

} // namespace linkdig::ig
