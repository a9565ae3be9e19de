#pragma once
/// Kelvin wakes along any path, summed into a field of heights (Glassner, "Duck!").
///
/// Wave (psi, u) left the swimmer s' = 2 psi cos u before the end of its path and ran at group speed, half its phase speed:
///   point = P(s') + T(s') psi cos^3 u - N(s') psi sin u cos^2 u,  N = T turned left,
/// which on a straight path is the end plus K(psi, u) of kelvin_curve.h.

#include "database/water/swimming_path.h"
#include "database/water/wave_field.h"

#include <cstdint>
#include <string>
#include <vector>

namespace linkdig::database {

/// How samples lie along a curve of one psi, and what each of them weighs.
enum class KelvinSampling : std::uint8_t {
    even,     ///< even along the curve, each with the length that it stands for: no rogue cells
    weighted, ///< even in u, each with the length that it stands for
    column, ///< even in u, all alike, as the column has it: cells at the cone's edge and the apex get out of hand
};

/// How a curve lies on a path that bends.
enum class KelvinLayout : std::uint8_t {
    rays,    ///< each wave runs straight on from where it left the swimmer
    tangent, ///< the whole curve along the tangent where psi has been swum, the column's literal way
};

/// What the swimmer did before the beginning of its path.
enum class KelvinBefore : std::uint8_t {
    straight, ///< it came straight on, for ever
    rest,     ///< it lay still: nothing left it before
};

struct KelvinSwimmer {
    std::string name{};
    std::vector<PathPiece> path{}; ///< without mistake (path_mistake)
    double speed = 1.0;            ///< units a second, > 0
    double amplitude = 1.0;        ///< of the wave as it leaves
    double oscillation_rad_s =
        1.0; ///< c of cos(c t); g / speed for water: transverse waves are 2 pi speed^2 / g long
    double damping_per_s = 0.0; ///< b of exp(-(b t)^2)
};

struct KelvinWakes {
    std::uint32_t size = 512; ///< cells a side, 4 to 8192
    double side = 512.0;      ///< units
    Vec2d origin{0};          ///< the grid's corner
    double psi_per_unit = 75.0;
    std::uint32_t u_steps = 750; ///< samples of a curve, at least 2; an odd number is made even
    KelvinSampling sampling = KelvinSampling::even;
    KelvinLayout layout = KelvinLayout::rays;
    KelvinBefore before = KelvinBefore::straight;
    std::vector<KelvinSwimmer> swimmers{};
};

struct KelvinCount {
    std::uint64_t samples = 0; ///< asked for: curves x u_steps
    std::uint64_t drawn = 0;   ///< of them those of a wave that the path has, and that the grid can hold
    std::uint64_t outside = 0; ///< of those drawn beyond the grid, left out
    double longest_cells = 0;  ///< length of the transverse waves, the longest
};

struct KelvinResult {
    WaveField field;
    std::vector<KelvinCount> swimmers; ///< parallel to the wakes'
};

/// The samples that the wakes take: what has to be waited for.
double sample_count(const KelvinWakes& wakes);

/// The sum of the swimmers' wakes. Even and weighted samples stand for dpsi dl / cell^2, so that the field does not depend on
/// how many there are; in them waves of less than two cells, which no grid can hold, are left out, and up to four cells they
/// fade in. Threads as TBB has them; the same bytes for any number.
KelvinResult kelvin_field(const KelvinWakes& wakes);

} // namespace linkdig::database
