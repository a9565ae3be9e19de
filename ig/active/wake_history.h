#pragma once
/// What the machine remembers of the wakes that it makes itself: plain values, a part of its history.

#include "database/model/vectors.h"

#include <cstdint>
#include <vector>

namespace linkdig::ig {

/// Where a ship was, and how fast.
struct TrackSample {
    double time_s = 0.0;
    Vec2d position_m{0.0};   ///< of the waterline's middle, world
    Vec2d forward{1.0, 0.0}; ///< unit
    double speed_mps = 0.0;  ///< through the water, along `forward`
    bool operator==(const TrackSample&) const = default;
};

/// A ship's last minutes, oldest sample first.
struct WakeTrail {
    std::uint32_t list = 0; ///< that its faces are made for
    std::vector<TrackSample> samples{};
    bool operator==(const WakeTrail&) const = default;
};

/// A bump of water that travels (ig/water/wave_particles.h). Where it is follows from where it spreads from, which way and how far: no
/// step adds an error to the last.
struct WaveParticle {
    Vec2d source{0.0}; ///< the point that it and its neighbours spread from; behind a quay its mirror image
    Vec2d direction{1.0, 0.0};   ///< unit
    double travelled = 0.0;      ///< metres from the source
    double amplitude = 0.0;      ///< metres, negative for a trough
    double dispersion_rad = 0.0; ///< the angle that it stands for; neighbours are that far apart

    Vec2d position() const { return source + direction * travelled; }
    bool operator==(const WaveParticle&) const = default;
};

/// Waves that a hull has made and that are still there.
struct ParticleWake {
    std::uint32_t list = 0; ///< that its faces are made for
    bool begun = false;
    double time_s = 0.0;     ///< up to which its particles have advanced
    double born_s = 0.0;     ///< when the last ones were born
    Vec3d position_m{0.0};   ///< the hull's, then
    Vec3d attitude_rad{0.0}; ///< heading, pitch, roll, then
    std::vector<WaveParticle> particles{};
    bool operator==(const ParticleWake&) const = default;
};

} // namespace linkdig::ig
