#include "ig/video/air_samples.h"

#include <algorithm>
#include <cmath>

namespace linkdig::ig {

namespace {

std::uint32_t samples_of(const Segment& run, int bits) {
    return ((run.count + (1U << bits) - 1) >> bits) + 1;
}

/// The longest stretches over which the run's transmission is straight enough, as bits; 0 if none are, or the run is so short
/// that two samples would cost as much as its pixels.
int longest_stretch(const Segment& run, float start, float along, const Air& air) {
    if (run.count <= 1U << shortest_stretch_bits) return 0;
    const int longest = run.count > 32 ? longest_stretch_bits : longest_stretch_bits - 1;
    for (int bits = longest; bits >= shortest_stretch_bits; --bits) {
        const auto length = static_cast<float>((samples_of(run, bits) - 1) << bits);
        const float least = std::min(start, start + length * along);
        if (std::fabs(along) <= air.little_change(bits) * least) return bits;
    }
    return 0;
}

} // namespace

std::size_t AirSamples::plan(std::span<const Segment> runs, const DepthPlane& depth, const Air& air) {
    const auto along = static_cast<float>(depth.along * air.m_per_octave());
    count = 0;
    std::size_t planned = 0;
    for (; planned < std::min(runs.size(), most_runs); ++planned) {
        const Segment& run = runs[planned];
        const double inverse_m = (depth.inverse_m + run.line * depth.across) + run.first * depth.along;
        const auto start = static_cast<float>(inverse_m * air.m_per_octave());
        const int bits = longest_stretch(run, start, along, air);
        of_run[planned] = {static_cast<std::uint32_t>(count), bits};
        if (bits == 0) continue;
        if (count + samples_of(run, bits) > most_samples) break;
        add(run, start, along, air.rays(run.line) + run.first, of_run[planned]);
    }
    std::fill_n(inverse.begin() + static_cast<std::ptrdiff_t>(count), vector, 1.0F);
    std::fill_n(rays.begin() + static_cast<std::ptrdiff_t>(count), vector, 1.0F);
    return planned;
}

void AirSamples::add(const Segment& run, float start, float along, const float* run_rays,
                     Stretches& stretches) {
    const std::uint32_t samples = samples_of(run, stretches.bits);
    for (std::uint32_t k = 0; k < samples; ++k) {
        const std::uint32_t behind = k << stretches.bits;
        inverse[count + k] = start + static_cast<float>(behind) * along;
        rays[count + k] = run_rays[behind];
    }
    count += samples;
}

} // namespace linkdig::ig
