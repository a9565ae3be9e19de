#pragma once
/// The waves that move the ships: a Bretschneider spectrum cut into components of equal energy. Long-crested,
/// deep water.

#include <cstdint>
#include <vector>

namespace linkdig::host {

/// What the sea does to the ships (the sea that is seen is the database's).
struct Seaway {
    double significant_height_m = 0.0;
    double modal_period_s = 10.0;
    double travel_heading_rad = 0.0; ///< where the waves run to, counter-clockwise from east
    std::uint64_t seed = 0;
    std::uint32_t components = 12;
};

/// One wave: elevation = amplitude cos(k s - w t + phase), s along its travel, w^2 = g k.
struct WaveComponent {
    double amplitude_m = 0.0;
    double frequency_rad_s = 0.0;
    double wave_number_rad_m = 0.0;
    double phase_rad = 0.0;
};

/// Spectral density in m^2 s: S(w) = (5/16) Hs^2 wm^4 / w^5 exp(-1.25 (wm/w)^4). 0 for w <= 0.
/// Source: common knowledge of naval architecture (two-parameter spectrum); its integral is Hs^2 / 16.
double bretschneider(double frequency_rad_s, double significant_height_m, double modal_period_s);

/// Components that carry equal shares of Hs^2 / 16, each at the middle of its share of energy, phases random
/// by seed. The energy below w is Hs^2/16 exp(-1.25 (wm/w)^4), which gives the frequencies in closed form.
std::vector<WaveComponent> wave_components(const Seaway& seaway);

/// Frequency at which a ship under way meets a wave: we = w - w^2 V cos(mu) / g, mu = 180 degrees in head
/// seas. Negative where the ship overtakes the wave.
double encounter_frequency(double frequency_rad_s, double speed_mps, double mu_rad);

} // namespace linkdig::host
