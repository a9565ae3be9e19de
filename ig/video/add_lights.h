#pragma once
/// Light points added to the picture: after its faces are drawn, each pixel gets the sum of its lights, rounded and
/// clamped once.

#include "ig/configuration.h"
#include "ig/geometry/projected_face.h"
#include "ig/scanline/segment.h"
#include "ig/video/line.h"
#include "ig/video/pixel_run.h"

#include <span>

namespace linkdig::ig {

/// Working storage of one thread.
struct LightSums {
    std::vector<Components> of_pixel;   ///< of the band's lines; all zero between calls
    std::vector<std::uint32_t> touched; ///< into of_pixel
};

/// `colours`: the database's table. Returns how many pixels got light.
std::uint64_t add_lights(std::span<const ProjectedLight> lights, std::span<const Colour> colours,
                         const Raster& raster, const BandSegments& band, LightSums& sums, VideoFrame& frame);

} // namespace linkdig::ig
