#pragma once
/// Light points, between geometry and scanline: each becomes the pixels that it shines into.
///
/// A splat is a round bump about the light's place (1/256 pixel): weight (R^2 - r^2)^2 at pixel centres within its
/// radius R. Weights are then divided up so that those of a splat sum to whole_splat *exactly*, wherever between pixels
/// it stands: running sums are rounded, never single weights. So a light that moves neither twinkles nor is lost.
/// Pixels beyond the picture's border keep their part, and nobody gets it.

#include "ig/configuration.h"
#include "ig/geometry/projected_face.h"

#include <cstdint>
#include <span>
#include <vector>

namespace linkdig::ig {

/// All weights of a splat together.
inline constexpr std::uint32_t whole_splat = 1U << 16U;

struct SplatPixel {
    std::uint16_t line = 0;
    std::uint16_t element = 0;
    std::uint32_t weight = 0; ///< of whole_splat
};

/// What one light shines into of one band of lines.
struct BandLight {
    std::uint32_t rank = 0;        ///< ProjectedLight::rank
    std::uint32_t light = 0;       ///< into ProjectedFaces::lights
    std::uint32_t first_pixel = 0; ///< into Splats::pixels
    std::uint32_t pixel_count = 0;
};

struct Splats {
    std::vector<SplatPixel> pixels;
    std::vector<BandLight> lights;    ///< band by band, in each ascending by rank
    std::vector<std::uint32_t> first; ///< per band: where its lights begin; one entry more at the end
    std::vector<BandLight> unsorted;  ///< working storage, as are the two below
    std::vector<std::uint32_t> band_of;
    std::vector<std::uint64_t> running;
    std::span<const BandLight> of(std::size_t band) const {
        return {lights.data() + first[band], lights.data() + first[band + 1]};
    }
};

/// Pixels of every light inside the picture, for bands of `lines_per_band` lines.
void make_splats(std::span<const ProjectedLight> lights, const Raster& raster, std::uint32_t lines_per_band,
                 Splats& splats);

} // namespace linkdig::ig
