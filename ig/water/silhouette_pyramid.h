#pragma once
/// Where a hull's waves start and which way they go: steps 3 to 6 of the silhouette pyramid (Yuksel), fast rather than exact.
///
/// Two things differ from its page. An outer boundary points away from the hull, not towards it; and a boundary pixel sends half
/// of its indirect effect up and keeps half, others send all: nothing is lost or counted twice.

#include "ig/water/silhouette.h"

namespace linkdig::ig {

/// Which pixels are the boundary: filled ones with an empty one beside them, or empty ones with a filled one beside them.
enum class SilhouetteBoundary : std::uint8_t { inner, outer };

/// Parallel to the silhouette's pixels.
struct BoundaryWaves {
    std::vector<std::uint8_t> boundary; ///< waves start here
    std::vector<Vec2d>
        direction; ///< unit, or zero where no direction is better than another; of a submerged hull inwards
    std::vector<double>
        dispersion_rad;           ///< mean angle to neighbours' directions; a full turn where there is none
    std::vector<double> indirect; ///< m^3/s, all of it on the boundary
    std::vector<double> direct;   ///< m^3/s, where it arose
};

/// What lies beyond the silhouette's square is empty. Without any boundary pixel the indirect effect stays where it was.
BoundaryWaves boundary_waves(const Silhouette& silhouette,
                             SilhouetteBoundary kind = SilhouetteBoundary::inner);

/// One resolution of the pyramid.
struct PyramidLevel {
    std::uint32_t size = 0;
    std::vector<std::uint8_t> boundary; ///< of the level below, how many of the four; at the lowest 1
    std::vector<Vec2d> direction;
    std::vector<double> effect;
};

/// The same, into waves that are there; `levels`, kept, spare the next call its memory.
void boundary_waves(const Silhouette& silhouette, SilhouetteBoundary kind, std::vector<PyramidLevel>& levels,
                    BoundaryWaves& waves);

} // namespace linkdig::ig
