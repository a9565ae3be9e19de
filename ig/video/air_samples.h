#pragma once
/// Transmission of a face's runs where it changes little from pixel to pixel: taken every 16, 32 or 64 elements, from the
/// run's first on, and straight between. The samples of many runs are worked out together, a vector at a time.

#include "ig/geometry/projected_face.h"
#include "ig/scanline/segment.h"
#include "ig/video/fog.h"
#include "ig/video/inverse_range.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace linkdig::ig {

/// How a run's transmission is taken: every 2^bits elements, the samples one behind the other; or at every pixel.
struct Stretches {
    std::uint32_t first_sample; ///< neither is written before it is planned
    int bits;                   ///< 0: at every pixel
    bool straight() const { return bits != 0; }
};

/// Working storage for the runs of one face.
struct AirSamples {
    static constexpr std::size_t most_runs = 64;
    static constexpr std::size_t most_samples = 512; ///< a run has 4096 / 16 + 1 at the most
    static constexpr std::size_t vector = 16;

    std::array<Stretches, most_runs> of_run;
    alignas(64) std::array<float, most_samples + vector> inverse; ///< 1/z, z in octaves
    alignas(64) std::array<float, most_samples + vector> rays;
    alignas(64) std::array<std::int32_t, most_samples + vector> transmissions; ///< 15 bits
    std::size_t count = 0;                                                     ///< samples

    AirSamples() {
    } // NOLINT(modernize-use-equals-default,cppcoreguidelines-pro-type-member-init): written before it is read

    /// Says how the first of these runs take their transmission, as many as there is room for, at least one; how many they are.
    std::size_t plan(std::span<const Segment> runs, const DepthPlane& depth, const Air& air);

    /// The transmissions from 1/z and the ray lengths.
    void work_out() {
        for (std::size_t k = 0; k < count; ++k)
            transmissions[k] = transmission_through(rays[k], inverse[k]);
    }

    /// Of a run's element k, straight between the two samples beside it, to the nearest.
    std::int32_t between(const Stretches& stretches, std::int32_t k) const {
        const std::int32_t* ends = transmissions.data() + stretches.first_sample + (k >> stretches.bits);
        const std::int32_t part = k & ((1 << stretches.bits) - 1);
        const std::int64_t rises = std::int64_t{ends[1] - ends[0]} * part;
        return static_cast<std::int32_t>(
            ((std::int64_t{ends[0]} << 16) + (1 << 15) + rises * (1 << (16 - stretches.bits))) >> 16);
    }

private:
    void add(const Segment& run, float start, float along, const float* run_rays, Stretches& stretches);
};

} // namespace linkdig::ig
