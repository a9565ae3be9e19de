#pragma once
/// A picture's visible faces against the ray caster's, pixel by pixel.

#include "ig/machine/machine.h"
#include "tools/check/caster.h"
#include "tools/check/exceptions.h"

#include <cstdint>
#include <vector>

namespace linkdig::tools {

/// What a picture has at every pixel: an index into CastScene::faces, or one of these.
inline constexpr std::int32_t background = -1;
inline constexpr std::int32_t absent = -2; ///< a face that the packet does not have in the active data base

/// A pixel whose visible face is wrong.
struct WrongPixel {
    std::uint32_t column = 0;
    std::uint32_t row = 0;
    std::int32_t shown = background;   ///< by the machine
    std::int32_t nearest = background; ///< by the caster
    double nearer_by_m = 0;            ///< endless_m if the ray does not meet the shown face at all
};

struct Comparison {
    std::uint64_t interior = 0;          ///< pixels more than a pixel from every edge, in both
    std::uint64_t as_near = 0;           ///< of these: another face, but within the tolerance
    std::vector<std::uint64_t> excepted; ///< parallel to the exceptions
    std::vector<WrongPixel> wrong;
};

/// The visible faces of the machine's channel 0; it must have drawn its rank plane.
std::vector<std::int32_t> faces_shown(const VisualDatabase& database, const ig::Machine& machine,
                                      const CastScene& scene);

/// Compares in interior pixels: those whose eight neighbours show the same face as they do, in the machine's picture
/// and in the caster's.
Comparison compare_faces(const std::vector<std::int32_t>& shown, const ig::Raster& raster,
                         const ChannelView& channel, const CastScene& scene, const Caster& caster,
                         const std::vector<DesignException>& exceptions);

} // namespace linkdig::tools
