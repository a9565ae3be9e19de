#pragma once
/// Stage 5, scanline: hidden faces removed by priority alone. Faces come front to back; a mask per line
/// remembers which elements are still open; a face gets what is open between its crossings. No depth is ever
/// compared.

#include "ig/configuration.h"
#include "ig/edges/edge.h"
#include "ig/lights/splat.h"
#include "ig/scanline/coverage.h"
#include "ig/scanline/opaque_faces.h"
#include "ig/scanline/segment.h"
#include "ig/scanline/smoothed_lines.h"

#include <array>
#include <span>

namespace linkdig::ig {

/// What is left of an element over which a level of detail fades: those of its faces that stand behind others of the
/// level stay hidden by them.
struct FadingPixel {
    std::int32_t level = -1;
    std::uint32_t left_by_level = 0;
};

/// Working storage of one thread.
struct BandScratch {
    OpenBand band;
    std::vector<std::uint32_t> left; ///< per element what no face has taken; whole_pixel between bands
    std::vector<FadingPixel> fading; ///< per element; reset between bands
    std::array<std::int32_t, band_lines> begin{}; ///< of the face at hand
    std::array<std::int32_t, band_lines> end{};
    OutlineLine traced;
    LineCoverage coverage;
    LinesLeft lines_left;
};

/// Resolves the lines [segments.first_line, segments.end_line), at most band_lines, for the faces of these ranks. With
/// smoothing faces count by the area that they cover, else by pixel centres.
void resolve_band(const FaceEdges& edges, std::span<const std::uint32_t> ranks, std::uint32_t elements,
                  bool smoothing, BandScratch& scratch, BandSegments& segments);

/// The same with the band's light points among the faces: a light gets of each of its pixels the share that the faces
/// in front of it have left, and takes nothing.
void resolve_band(const FaceEdges& edges, std::span<const std::uint32_t> ranks,
                  std::span<const BandLight> lights, std::span<const SplatPixel> splats,
                  std::uint32_t elements, bool smoothing, BandScratch& scratch, BandSegments& segments);

} // namespace linkdig::ig
