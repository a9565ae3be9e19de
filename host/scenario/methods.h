#pragma once
/// The report's methods by their names: how ship and sea occult one another, what wakes are made of, and how the sea moves.

#include <array>
#include <cstddef>
#include <cstdint>

namespace linkdig::host {

/// Occulting of ship and sea (report, 3.3).
enum class Occulting : std::uint8_t {
    none, ///< hull modelled below the waterline, and the ocean has the priority: only what rises above the horizon is seen
    waterline,  ///< modelled to the waterline, priority over the ocean (3.3.2: what the report recommends)
    priority,   ///< hull modelled below the waterline, priority over the ocean: she floats on her keel
    box,        ///< the same, and a plain moving box around what is below the water (3.3.1.1)
    fitted_box, ///< the same with a box of the hull's shape
    wedges, ///< modelled to the waterline; wedge faces fill the gap under bow and stern with pitch (3.3.1.2)
};
inline constexpr std::array occulting_names{"none", "waterline", "priority", "box", "fitted_box", "wedges"};

/// What a wake is made of (report, 3.2); several may be shown at once.
enum class Wake : std::uint8_t {
    white_v,           ///< a white "V" on the water (3.2.1)
    blended_v,         ///< the same, blended by many faces and smooth shading (3.2.1)
    cam,               ///< rolling cams as moving objects (3.2.2)
    face_substitution, ///< 28 faces, one at a time (3.2.2)
    solid,             ///< the same as a solid (3.2.3 calls it complex)
    churned,           ///< bow and stern patterns under a fast sun of their own, added to the sea's (3.2.3)
    kelvin,            ///< made at frame time of her last minutes' track
    wave_particles,    ///< made at frame time of what her hull does to the water
};
inline constexpr std::array wake_names{"white_v", "blended_v", "cam",    "face_substitution",
                                       "solid",   "churned",   "kelvin", "wave_particles"};
inline constexpr std::size_t wake_count = wake_names.size();
using Wakes = std::array<bool, wake_count>;

/// How the sea moves (report, 3.1.4).
enum class SeaMethod : std::uint8_t {
    sun,     ///< its sun turns: one vector a frame
    normals, ///< the host turns every vertex normal
};
inline constexpr std::array sea_method_names{"sun", "normals"};

/// The report's sea states as presets of the ocean's sun. Estimated for normals that stand 68 degrees up: contrast
/// cos 68 cos e, none at 90, 0.19 at 60 and 0.34 at 24 degrees.
struct SeaState {
    const char* name;
    double state;
    double elevation_deg;
    double azimuth_rate_deg_s; ///< agitation
};
inline constexpr std::array sea_states{SeaState{"0", 0.0, 90.0, 0.0}, SeaState{"1-2", 1.5, 60.0, 72.0},
                                       SeaState{"3", 3.0, 24.0, 120.0}};

} // namespace linkdig::host
