#include "host/motion/ship_motion.h"

#include "database/model/mathematics.h"
#include "database/model/rotation.h"

#include <cmath>

namespace linkdig::host {

namespace {

/// Scales an axis down, if need be, so that even all its sinusoids at their peaks stay within the limit: the
/// motion is bounded for all time and remains a sum of sinusoids, without flat tops.
void limit(std::vector<Harmonic>& harmonics, double greatest) {
    double sum = 0.0;
    for (const Harmonic& each : harmonics)
        sum += std::fabs(each.amplitude);
    if (sum <= greatest) return;
    for (Harmonic& each : harmonics)
        each.amplitude *= greatest / sum;
}

Harmonic harmonic(ShipAxis axis, const ShipResponse& ship, const WaveComponent& wave, double mu_rad,
                  double encounter_rad_s) {
    const AxisResponse& response = ship[axis];
    const WaveForcing forcing = wave_forcing(axis, wave.wave_number_rad_m, mu_rad, ship.length_m);
    const Oscillation answer = oscillation(response, encounter_rad_s);
    const double quarter = forcing.quadrature ? pi / 2.0 : 0.0;
    return {.amplitude = wave.amplitude_m * forcing.gain * response.gain * answer.gain,
            .frequency_rad_s = encounter_rad_s,
            .phase_rad = -wave.phase_rad - answer.lag_rad - quarter};
}

} // namespace

ShipResponse large_ship_response() {
    ShipResponse ship;
    ship[ShipAxis::surge] = {.gain = 0.5, .limit = 2.0};
    ship[ShipAxis::sway] = {.gain = 0.5, .limit = 2.0};
    ship[ShipAxis::heave] = {.gain = 1.0, .natural_period_s = 8.0, .damping = 0.5, .limit = 3.0};
    // Period 2 pi k / sqrt(g GM) with k = 0.39 x 25.6 m beam and GM about 2 m (estimated).
    ship[ShipAxis::roll] = {.gain = 1.0, .natural_period_s = 14.0, .damping = 0.12, .limit = radians(8.0)};
    ship[ShipAxis::pitch] = {.gain = 1.0, .natural_period_s = 7.5, .damping = 0.5, .limit = radians(5.0)};
    ship[ShipAxis::yaw] = {.gain = 0.3, .limit = radians(2.0)};
    return ship;
}

/// The wave at a point x forward and y to port of the ship: a cos(k (x cos mu + y sin mu) - we t + phase).
/// Heave is its height, pitch its slope forward, roll its slope to port; surge and sway the path of its
/// particles, a sin(we t - phase) along its travel; yaw in proportion to the twist of the slope (estimated).
/// Averaging over the length L is that of sin(q)/q, q = k L |cos mu| / 2, to second order: exp(-q^2 / 6) has
/// no zeros in which a motion would stop.
WaveForcing wave_forcing(ShipAxis axis, double wave_number_rad_m, double mu_rad, double length_m) {
    const SineCosine mu = sine_cosine(mu_rad);
    const double q = wave_number_rad_m * length_m * mu.cosine / 2.0;
    const double averaged = exponential(-q * q / 6.0);
    switch (axis) {
    case ShipAxis::surge:
        return {averaged * mu.cosine, true};
    case ShipAxis::sway:
        return {averaged * mu.sine, true};
    case ShipAxis::heave:
        return {averaged, false};
    case ShipAxis::roll:
        return {averaged * wave_number_rad_m * mu.sine, true};
    case ShipAxis::pitch:
        return {averaged * wave_number_rad_m * mu.cosine, true};
    case ShipAxis::yaw:
        return {averaged * wave_number_rad_m * mu.sine * mu.cosine, false};
    }
    return {};
}

/// x'' + 2 z wn x' + wn^2 x = wn^2 cos(w t): gain 1 / sqrt((1 - r^2)^2 + (2 z r)^2), lag atan2(2 z r, 1 -
/// r^2), r = w / wn.
Oscillation oscillation(const AxisResponse& response, double frequency_rad_s) {
    if (response.natural_period_s <= 0.0) return {};
    const double ratio = frequency_rad_s * response.natural_period_s / two_pi;
    const double in_phase = 1.0 - ratio * ratio;
    const double out_of_phase = 2.0 * response.damping * ratio;
    return {1.0 / std::sqrt(in_phase * in_phase + out_of_phase * out_of_phase),
            arc_tangent(out_of_phase, in_phase)};
}

ShipMotion::ShipMotion(const Seaway& seaway, const ShipResponse& response, double heading_rad,
                       double speed_mps) {
    const double mu = seaway.travel_heading_rad - heading_rad;
    const std::vector<WaveComponent> waves = wave_components(seaway);
    for (std::size_t axis = 0; axis < ship_axes; ++axis) {
        for (const WaveComponent& wave : waves) {
            const double encounter = encounter_frequency(wave.frequency_rad_s, speed_mps, mu);
            harmonics_[axis].push_back(harmonic(static_cast<ShipAxis>(axis), response, wave, mu, encounter));
        }
        limit(harmonics_[axis], response.axes[axis].limit);
    }
}

CurvedMotion::CurvedMotion(const Seaway& seaway, const ShipResponse& response, double speed_mps)
    : waves_(wave_components(seaway)), response_(response), travel_heading_rad_(seaway.travel_heading_rad),
      speed_mps_(speed_mps) {}

ShipMotionValues CurvedMotion::at(double time_s, const Steering& steering) const {
    const double mu = travel_heading_rad_ - steering.heading_rad;
    const double along_m = glm::dot(steering.position_m, direction(travel_heading_rad_, 0.0));
    ShipMotionValues values{};
    for (std::size_t axis = 0; axis < ship_axes; ++axis) {
        double sum = 0.0;
        for (const WaveComponent& wave : waves_) {
            const double encounter = encounter_frequency(wave.frequency_rad_s, speed_mps_, mu);
            const Harmonic each = harmonic(static_cast<ShipAxis>(axis), response_, wave, mu, encounter);
            values[axis] += each.amplitude * cosine(wave.frequency_rad_s * time_s -
                                                    wave.wave_number_rad_m * along_m + each.phase_rad);
            sum += std::fabs(each.amplitude);
        }
        const double greatest = response_.axes[axis].limit;
        if (sum > greatest) values[axis] *= greatest / sum; // changes with the course, without a jump
    }
    return values;
}

ShipMotionValues ShipMotion::at(double time_s) const {
    ShipMotionValues values{};
    for (std::size_t axis = 0; axis < ship_axes; ++axis)
        for (const Harmonic& each : harmonics_[axis])
            values[axis] += each.amplitude * cosine(each.frequency_rad_s * time_s + each.phase_rad);
    return values;
}

} // namespace linkdig::host
