#include "ig/video/see.h"

#include "ig/edges/edges.h"
#include "ig/video/colour_run.h"

#include <algorithm>

namespace linkdig::ig {

Seen see(const VideoInput& input, std::uint32_t rank, std::uint32_t line, std::uint32_t element) {
    const ProjectedFace& face = input.projected->faces[rank];
    const FaceShading& shading = input.edges->shadings[rank];
    const auto l = static_cast<std::int32_t>(line), e = static_cast<std::int32_t>(element);
    Seen seen;
    if (shading.coloured) {
        const Tint tint = tint_at(tint_of(*input.edges, shading).data(), l, e);
        seen.light = lit(tint);
        seen.intensity = std::max({tint[0], tint[1], tint[2]});
    } else {
        seen.intensity = intensity_at(shading.plane, l, e);
        seen.light = lit(input.colours[shading.colour], seen.intensity);
    }
    const Air& air = *input.air;
    if (air.clear() || face.depth < 0) return seen;
    const DepthPlane& depth = input.projected->depths[static_cast<std::size_t>(face.depth)];
    seen.transmission = transmission_of(input.face_air[rank], depth, air, l, e);
    seen.light = through_air(seen.light, seen.transmission, face.added_to != none ? Colour{} : air.horizon());
    return seen;
}

} // namespace linkdig::ig
