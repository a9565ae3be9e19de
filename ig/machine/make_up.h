#pragma once
/// What a pixel's colour is made of: the shares that its faces, the background and light points have in it.

#include "ig/configuration.h"
#include "ig/lights/splat.h"
#include "ig/scanline/bands.h"
#include "ig/video/see.h"

#include <cstdint>
#include <vector>

namespace linkdig::ig {

/// What one face, or the background, gives to a pixel.
struct PixelShare {
    std::uint32_t rank = 0;     ///< background_rank: the background
    std::uint32_t weight = 0;   ///< of whole_pixel; those of ordinary faces and of the background sum to it
    Colour code;                ///< of the packet's table, if it sends one; of a coloured face meaningless
    Seen seen;                  ///< of a background only `light` counts
    std::int32_t added_to = -1; ///< an additive face: the list that its light, x weight, falls on
    bool falls_on_none = false; ///< no face of that list behind it gets it
};

/// What one light point adds.
struct PixelLight {
    Colour code;
    double levels[3] = {0, 0, 0}; ///< red, green, blue
};

struct PixelMakeUp {
    std::vector<PixelShare> shares; ///< front to back
    std::vector<PixelLight> lights;
    Colour horizon; ///< what the air turns colours into
};

/// A channel's last frame as scanline and video take it.
struct DrawnChannel {
    VideoInput video;
    const Bands* bands = nullptr;
    const Splats* splats = nullptr;
    Raster raster;
    bool smoothing = false;
};

/// Resolves the pixel's band once more and takes out what the pixel has of it.
PixelMakeUp make_up(const DrawnChannel& drawn, std::uint32_t line, std::uint32_t element);

} // namespace linkdig::ig
