#include "ig/video/fog.h"

#include <algorithm>
#include <cmath>

namespace linkdig::ig {

void Air::prepare(const PictureScale& scale, const Raster& raster, double visibility_m, Colour horizon) {
    visibility_m_ = visibility_m;
    horizon_ = horizon;
    if (clear()) return;
    m_per_octave_ = natural_logarithm_of_2 * visibility_m / extinction_at_visibility;
    make_rays(scale, raster);
}

void Air::make_rays(const PictureScale& scale, const Raster& raster) {
    if (scale == made_for_ && raster == made_raster_) return;
    made_for_ = scale;
    made_raster_ = raster;
    rays_of_line_ = raster.elements() + rays_behind;
    const bool vertical = raster.scan == Scan::vertical;
    const double column_slope = 256.0 / scale.x_scale,
                 column_start = (128.0 - scale.x_offset) / scale.x_scale;
    const double row_slope = 256.0 / scale.y_scale, row_start = (128.0 - scale.y_offset) / scale.y_scale;
    slopes_ = vertical ? AirRays{row_start, row_slope, column_start, column_slope}
                       : AirRays{column_start, column_slope, row_start, row_slope};
    const double tangent_step = std::fabs(slopes_.element_slope);
    for (int bits = shortest_stretch_bits; bits <= longest_stretch_bits; ++bits)
        little_change_[static_cast<std::size_t>(bits)] = static_cast<float>(1.0 / (8 << bits) - tangent_step);
    rays_.resize(std::size_t{raster.lines()} * rays_of_line_ + rays_padding, 1.0F);
    for (std::uint32_t line = 0; line < raster.lines(); ++line) {
        for (std::uint32_t element = 0; element < rays_of_line_; ++element) {
            const double column = 256.0 * (vertical ? line : element) + 128.0;
            const double row = 256.0 * (vertical ? element : line) + 128.0;
            const double tx = (column - scale.x_offset) / scale.x_scale;
            const double ty = (row - scale.y_offset) / scale.y_scale;
            rays_[std::size_t{line} * rays_of_line_ + element] =
                static_cast<float>(std::sqrt(1.0 + tx * tx + ty * ty));
        }
    }
}

std::int32_t Air::transmission_at(double range_m) const {
    return transmission_over(std::min(static_cast<float>(range_m / m_per_octave_), most_octaves));
}

bool Air::is_flat(const DepthPlane& depth, std::int32_t& transmission) const {
    const std::int32_t greatest = transmission_at(depth.nearest_m);
    const std::int32_t least = transmission_at(depth.farthest_m);
    transmission = (greatest + least) / 2;
    return greatest - least <= transmission_one / 255;
}

} // namespace linkdig::ig
