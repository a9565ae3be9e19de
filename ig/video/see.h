#pragma once
/// What is seen of one face in one pixel, before anything else has a share in it.

#include "ig/video/pixel_run.h"
#include "ig/video/video_input.h"

#include <cstdint>

namespace linkdig::ig {

struct Seen {
    Components light;               ///< its colour, lit and through the air before it
    std::int32_t intensity = -1;    ///< 1.0 = 2^22; of a coloured face that of its brightest component
    std::int32_t transmission = -1; ///< of that air, 15 bits; -1: clear
};

/// The face of a rank. Light that is added brings no horizon of its own: the face behind it does.
Seen see(const VideoInput& input, std::uint32_t rank, std::uint32_t line, std::uint32_t element);

} // namespace linkdig::ig
