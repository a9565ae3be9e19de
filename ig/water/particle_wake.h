#pragma once
/// A ship's wake of wave particles: her hull as it floats and moves makes them, and their sum on a grid that follows her becomes faces.

#include "host/packet/frame_packet.h"
#include "ig/active/face_block.h"
#include "ig/active/wake_history.h"
#include "ig/water/silhouette.h"
#include "ig/water/wave_particles.h"

namespace linkdig::ig {

inline constexpr double birth_interval_s = 0.5;         ///< between two silhouettes
inline constexpr std::uint32_t silhouette_pixels = 32;  ///< a side
inline constexpr std::uint32_t most_particles = 30'000; ///< of one ship

/// The faces of her hull below and above the waterline as triangles, in the body's axes.
std::vector<HullTriangle> hull_of(const VisualDatabase& database, const WakeRequest& wake);

/// Vertices along a side of the grid that the request's reserve allows.
std::uint32_t grid_side(const WakeRequest& wake);

/// What making one ship's wake takes besides her history: nothing in it outlives a frame but memory.
class ParticleWakeMaker {
public:
    ParticleWakeMaker(const VisualDatabase& database, const WakeRequest& wake);

    std::uint32_t list() const { return list_; }

    /// Does it still serve this request for its list?
    bool serves(const WakeRequest& wake) const;

    /// Brings the particles up to the packet. They begin anew where the packet says that the scene jumped, where time went back, and
    /// after a gap of more than five seconds.
    void follow(const WakeRequest& wake, const FramePacket& packet, ParticleWake& history);

    /// Makes the faces that are not dark, in the pools of `active`.
    void make_faces(const WakeRequest& wake, const FramePacket& packet, ParticleWake& history,
                    ActiveDatabase& active, FaceBlock& block);

private:
    void give_birth(const MovingObject& ship, double duration_s, const ParticleWake& history);

    std::uint32_t list_;
    std::array<std::int32_t, 2> hull_lists_; ///< below and above the waterline
    float length_m_;
    std::uint32_t faces_;
    std::vector<HullTriangle> hull_;
    WaveParticles particles_;
    WaveParticleCount count_{};
    SilhouetteScratch silhouette_scratch_;
    Silhouette silhouette_;
    std::vector<PyramidLevel> levels_;
    BoundaryWaves waves_;
};

} // namespace linkdig::ig
