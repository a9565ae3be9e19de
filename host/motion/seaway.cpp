#include "host/motion/seaway.h"

#include "database/model/mathematics.h"
#include "database/model/random.h"
#include "database/model/units.h"

#include <cmath>

namespace linkdig::host {

double bretschneider(double frequency_rad_s, double significant_height_m, double modal_period_s) {
    if (frequency_rad_s <= 0.0) return 0.0;
    const double modal = two_pi / modal_period_s;
    const double ratio = modal / frequency_rad_s;
    const double fourth = ratio * ratio * ratio * ratio;
    return (5.0 / 16.0) * significant_height_m * significant_height_m * fourth / frequency_rad_s *
           exponential(-1.25 * fourth);
}

std::vector<WaveComponent> wave_components(const Seaway& seaway) {
    std::vector<WaveComponent> components;
    const double modal = two_pi / seaway.modal_period_s;
    const double variance = seaway.significant_height_m * seaway.significant_height_m / 16.0;
    const double count = static_cast<double>(seaway.components);
    for (std::uint32_t i = 0; i < seaway.components; ++i) {
        const double energy_below = (static_cast<double>(i) + 0.5) / count;
        const double frequency = modal * std::sqrt(std::sqrt(1.25 / -logarithm(energy_below)));
        components.push_back({.amplitude_m = std::sqrt(2.0 * variance / count),
                              .frequency_rad_s = frequency,
                              .wave_number_rad_m = frequency * frequency / gravity_mps2,
                              .phase_rad = two_pi * random_unit(seaway.seed, i)});
    }
    return components;
}

double encounter_frequency(double frequency_rad_s, double speed_mps, double mu_rad) {
    return frequency_rad_s - frequency_rad_s * frequency_rad_s * speed_mps * cosine(mu_rad) / gravity_mps2;
}

} // namespace linkdig::host
