#pragma once
/// The shared pixels of a band: shares are added up front to back, each pixel is rounded, clamped and written once.

#include "ig/scanline/segment.h"
#include "ig/video/beam.h"
#include "ig/video/video_input.h"

#include <cstdint>
#include <vector>

namespace linkdig::ig {

/// Of a shared pixel, where planes are wanted.
struct PixelTale {
    std::uint32_t rank = background_rank; ///< of the face with the largest share so far
    std::uint32_t rank_weight = 0;
    std::int32_t intensity = -1; ///< of that face
};

/// Light of additive faces over the band's pixels, until a face of the list that they name tells that it counts. All zero between
/// bands.
struct WaitingLight {
    std::int32_t list = -1;                      ///< that they are added to
    std::vector<std::uint32_t> red, green, blue; ///< per element, 7 fraction bits, and sums_padding more
    std::vector<std::uint64_t> there;            ///< a bit per element, BandSegments::words a line
};

/// Working storage of one thread: per element of the band what its shares have added up to, component x weight,
/// components with 7 fraction bits. All zero between bands, and sums_padding more.
struct ShareSums {
    std::vector<std::uint32_t> red, green, blue;
    std::vector<PixelTale> tales;      ///< per element; as made between bands
    std::vector<WaitingLight> waiting; ///< one of each list that light is added to: seldom more than one
    std::size_t lists_waiting = 0;     ///< of them in this band
};

/// Draws the shared pixels of a band.
void draw_shares(const VideoInput& input, const Raster& raster, const BandSegments& band,
                 const BeamBuffer& beam, ShareSums& sums, VideoFrame& frame);

} // namespace linkdig::ig
