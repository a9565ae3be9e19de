#pragma once
/// Waves as particles (Yuksel, House, Keyser: Wave Particles, SIGGRAPH 2007): each carries a bump of water along at a constant speed.

#include "database/water/wave_field.h"
#include "host/packet/frame_packet.h"
#include "ig/active/wake_history.h"
#include "ig/water/silhouette_pyramid.h"

#include <cstdint>
#include <span>
#include <vector>

namespace linkdig::ig {

/// Of all particles of one water.
struct WaveParticleKind {
    double speed_mps = 5.0;
    double radius = 4.0;            ///< of a bump, metres
    double least_amplitude = 0.001; ///< metres; a particle below it is removed
    double lifetime_s = 60.0;       ///< amplitude falls to 1/e in this time
    double rise_m = 0.0; ///< on its first metres a bump grows to its amplitude, so that none is there at once
    std::uint32_t most = 200'000; ///< reserved; what would go beyond is not born or not subdivided
};

/// What became of particles in one frame.
struct WaveParticleCount {
    std::uint32_t born = 0;
    std::uint32_t subdivided = 0;
    std::uint32_t removed = 0;
    std::uint32_t reflected = 0;
    std::uint32_t refused = 0; ///< for want of room
};

/// A grid of whole cells that are fixed in the world; only which of them are looked at follows the ship.
struct SurfaceGrid {
    std::uint32_t size = 512; ///< cells a side
    double cell = 1.0;        ///< metres
    Vec2d centre{0.0}; ///< the ship; the grid's corner is the cell boundary nearest to half a side from it
};

class WaveParticles {
public:
    /// Throws std::invalid_argument if speed, radius or lifetime is not above 0.
    explicit WaveParticles(const WaveParticleKind& kind);

    /// One more, if there is room. A null direction becomes +x; amplitudes beyond 1,000 m are cut to that.
    bool add(const WaveParticle& particle, WaveParticleCount& count);

    /// Step 6 of the pyramid: particles of what a hull did in `duration_s`. Each holds as much water as its pixel sends.
    void add(const Silhouette& silhouette, const BoundaryWaves& waves, double duration_s,
             WaveParticleCount& count);

    /// On by `duration_s`: along, back from quays, in three where neighbours are more than half a radius apart, out when too low.
    void advance(double duration_s, std::span<const Quay> quays, WaveParticleCount& count);

    /// The sum of all bumps, in fixed point: the same bytes for any number of threads and any order of particles.
    /// Holds until the next call, which takes the same memory. Throws std::invalid_argument if the grid's cell is not above 0, or if it
    /// has none.
    const database::WaveField& surface(const SurfaceGrid& grid);

    const std::vector<WaveParticle>& particles() const { return particles_; }
    /// Exchanges all particles for others, as a history keeps them.
    void exchange(std::vector<WaveParticle>& particles) {
        particles_.swap(particles);
        particles_.reserve(kind_.most);
    }
    const WaveParticleKind& kind() const { return kind_; }

    /// The water in a bump one metre high, m^3.
    double water_of_unit() const;

private:
    /// A bump on the grid, in cells.
    struct Splat {
        float column;
        float row;
        float amplitude; ///< in the sums' unit
    };
    /// Rows and columns of the sums, with room on both sides of each row, so that whole runs of columns fit.
    struct Sums {
        std::int64_t stride = 0;
        std::int64_t columns_before = 0;
        std::vector<std::int32_t> cells{};
    };
    struct Band {
        std::uint32_t first; ///< row
        std::uint32_t last;  ///< beyond its last row
    };
    static void add_bump(const Splat& splat, float radius, const Band& rows, Sums& sums);
    void sort_into_bands(const SurfaceGrid& grid, const Vec2d& corner, double one);

    WaveParticleKind kind_;
    std::vector<WaveParticle> particles_;
    std::vector<std::vector<Splat>> bands_; ///< bumps by the bands of rows that they reach
    Sums sums_;
    database::WaveField field_;
};

} // namespace linkdig::ig
