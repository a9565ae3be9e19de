#include "host/motion/ship.h"

#include "database/model/mathematics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace linkdig::host {
namespace {

constexpr Seaway swell{.significant_height_m = 2.5,
                       .modal_period_s = 12.0,
                       .travel_heading_rad = 2.5,
                       .seed = 7,
                       .components = 48};

/// Root of the integral of the spectrum times a squared response, by the trapezoidal rule with the C library.
double spectral_rms(const std::function<double(double)>& response) {
    double sum = 0.0;
    const double step = 0.0005;
    for (double w = 0.05; w < 20.0; w += step) {
        const double modal = two_pi / swell.modal_period_s;
        const double density = 5.0 / 16.0 * 6.25 * std::pow(modal, 4) / std::pow(w, 5) *
                               std::exp(-1.25 * std::pow(modal / w, 4));
        sum += density * response(w) * response(w) * step;
    }
    return std::sqrt(sum);
}

double rms_over_time(const ShipMotion& motion, ShipAxis axis) {
    double sum = 0.0;
    const int samples = 40000;
    for (int i = 0; i < samples; ++i) {
        const double value = motion.at(i * 0.5)[static_cast<std::size_t>(axis)];
        sum += value * value;
    }
    return std::sqrt(sum / samples);
}

ShipResponse without_limits() {
    ShipResponse response = large_ship_response();
    for (AxisResponse& each : response.axes)
        each.limit = 1e6;
    return response;
}

TEST(Bretschneider, IntegratesToASixteenthOfTheSquaredHeight) {
    double sum = 0.0;
    for (double w = 0.0; w < 60.0; w += 0.001)
        sum += bretschneider(w, 2.0, 9.0) * 0.001;
    EXPECT_NEAR(sum, 4.0 / 16.0, 1e-5);
    EXPECT_EQ(bretschneider(0.0, 2.0, 9.0), 0.0);
    EXPECT_EQ(bretschneider(-1.0, 2.0, 9.0), 0.0);
    const double modal = two_pi / 9.0;
    EXPECT_GT(bretschneider(modal, 2.0, 9.0), bretschneider(modal * 0.99, 2.0, 9.0));
    EXPECT_GT(bretschneider(modal, 2.0, 9.0), bretschneider(modal * 1.01, 2.0, 9.0));
}

TEST(WaveComponents, CarryAllTheEnergyInEqualShares) {
    for (const std::uint32_t count : {1U, 12U, 64U}) {
        Seaway sea = swell;
        sea.components = count;
        const std::vector<WaveComponent> waves = wave_components(sea);
        ASSERT_EQ(waves.size(), count);
        double variance = 0.0;
        for (const WaveComponent& each : waves) {
            variance += each.amplitude_m * each.amplitude_m / 2.0;
            EXPECT_NEAR(each.wave_number_rad_m * 9.80665, each.frequency_rad_s * each.frequency_rad_s, 1e-12);
        }
        EXPECT_NEAR(variance, 2.5 * 2.5 / 16.0, 1e-12);
    }
    EXPECT_EQ(wave_components(Seaway{}).front().amplitude_m, 0.0) << "a calm";
}

TEST(EncounterFrequency, IsHigherInHeadSeasAndTurnsNegativeWhenTheShipOvertakes) {
    EXPECT_NEAR(encounter_frequency(0.5, 6.0, pi), 0.5 + 0.25 * 6.0 / 9.80665, 1e-12);
    EXPECT_NEAR(encounter_frequency(0.5, 6.0, pi / 2.0), 0.5, 1e-12);
    EXPECT_LT(encounter_frequency(2.0, 10.0, 0.0), 0.0);
    EXPECT_EQ(encounter_frequency(0.5, 0.0, 1.0), 0.5);
}

/// A forced oscillator integrated step by step must show the gain and the lag of the formula.
TEST(Oscillation, AgreesWithAnIntegratedOscillator) {
    const AxisResponse axis{.natural_period_s = 8.0, .damping = 0.3};
    const double natural = two_pi / 8.0;
    for (const double frequency : {0.3, natural, 1.4}) {
        double x = 0.0;
        double v = 0.0;
        double greatest = 0.0;
        double last_forcing_peak_error = 0.0;
        const Oscillation answer = oscillation(axis, frequency);
        const double step = 0.001;
        for (int i = 0; i < 200000; ++i) {
            const double t = i * step;
            if (t > 150.0) {
                greatest = std::max(greatest, std::fabs(x));
                const double formula = answer.gain * std::cos(frequency * t - answer.lag_rad);
                last_forcing_peak_error = std::max(last_forcing_peak_error, std::fabs(x - formula));
            }
            v += step * (natural * natural * (std::cos(frequency * t) - x) - 2.0 * 0.3 * natural * v);
            x += step * v;
        }
        EXPECT_NEAR(greatest, answer.gain, 0.005);
        EXPECT_LT(last_forcing_peak_error, 0.005) << frequency;
    }
    EXPECT_EQ(oscillation({}, 3.0).gain, 1.0);
}

TEST(ShipMotion, AtRestAndInACalmNothingMoves) {
    const ShipMotion calm(Seaway{}, large_ship_response(), 0.3, 6.0);
    for (const double value : ShipMotion().at(12.0))
        EXPECT_EQ(value, 0.0);
    for (const double value : calm.at(12.0))
        EXPECT_EQ(value, 0.0);
}

/// RMS over 20,000 s against the spectrum's own integral, with responses written out anew.
TEST(ShipMotion, HasTheRmsThatTheSpectrumGives) {
    const double heading = 0.2;
    const double speed = 6.0;
    const double mu = swell.travel_heading_rad - heading;
    const ShipMotion motion(swell, without_limits(), heading, speed);
    const auto averaged = [&](double w) {
        const double q = w * w / 9.80665 * 180.0 * std::cos(mu) / 2.0;
        return std::exp(-q * q / 6.0);
    };
    const auto resonance = [&](double w, double period, double damping) {
        const double r = (w - w * w * speed * std::cos(mu) / 9.80665) * period / two_pi;
        return 1.0 / std::hypot(1.0 - r * r, 2.0 * damping * r);
    };
    const double heave = spectral_rms([&](double w) { return averaged(w) * resonance(w, 8.0, 0.5); });
    const double pitch = spectral_rms(
        [&](double w) { return averaged(w) * w * w / 9.80665 * std::cos(mu) * resonance(w, 7.5, 0.5); });
    const double surge = spectral_rms([&](double w) { return 0.5 * averaged(w) * std::cos(mu); });
    const double roll = spectral_rms(
        [&](double w) { return averaged(w) * w * w / 9.80665 * std::sin(mu) * resonance(w, 14.0, 0.12); });
    EXPECT_NEAR(rms_over_time(motion, ShipAxis::heave) / heave, 1.0, 0.03);
    EXPECT_NEAR(rms_over_time(motion, ShipAxis::pitch) / pitch, 1.0, 0.03);
    EXPECT_NEAR(rms_over_time(motion, ShipAxis::surge) / surge, 1.0, 0.03);
    EXPECT_NEAR(rms_over_time(motion, ShipAxis::roll) / roll, 1.0, 0.06);
}

TEST(ShipMotion, ScalesWithTheHeightOfTheWaves) {
    Seaway twice = swell;
    twice.significant_height_m *= 2.0;
    const ShipMotion small(swell, without_limits(), 0.2, 6.0);
    const ShipMotion large(twice, without_limits(), 0.2, 6.0);
    for (std::size_t axis = 0; axis < ship_axes; ++axis)
        EXPECT_NEAR(large.at(33.0)[axis], 2.0 * small.at(33.0)[axis], 1e-12) << axis;
}

TEST(ShipMotion, NeverExceedsItsLimits) {
    Seaway storm = swell;
    storm.significant_height_m = 15.0;
    const ShipResponse response = large_ship_response();
    const ShipMotion motion(storm, response, 0.2, 6.0);
    for (std::size_t axis = 0; axis < ship_axes; ++axis) {
        double sum = 0.0;
        for (const Harmonic& each : motion.harmonics(static_cast<ShipAxis>(axis)))
            sum += std::fabs(each.amplitude);
        EXPECT_LE(sum, response.axes[axis].limit * (1.0 + 1e-12)) << axis;
        for (int i = 0; i < 5000; ++i)
            ASSERT_LE(std::fabs(motion.at(i * 0.7)[axis]), response.axes[axis].limit * (1.0 + 1e-12));
    }
}

TEST(ShipMotion, RepeatsWithItsSeedAndDiffersWithAnother) {
    Seaway other = swell;
    other.seed = 8;
    const ShipMotion first(swell, large_ship_response(), 0.2, 6.0);
    const ShipMotion again(swell, large_ship_response(), 0.2, 6.0);
    const ShipMotion different(other, large_ship_response(), 0.2, 6.0);
    EXPECT_EQ(first.at(77.0), again.at(77.0));
    EXPECT_NE(first.at(77.0), different.at(77.0));
}

/// In long head seas the ship rides the contour: bow up while the crest comes, level on the crest.
TEST(ShipMotion, PitchesBowUpBeforeTheCrestOfALongHeadSea) {
    const double k = two_pi / 3000.0;
    const WaveForcing pitch = wave_forcing(ShipAxis::pitch, k, pi, 180.0);
    const WaveForcing heave = wave_forcing(ShipAxis::heave, k, pi, 180.0);
    EXPECT_TRUE(pitch.quadrature);
    EXPECT_FALSE(heave.quadrature);
    // Quadrature is sin(we t - phase): negative before the crest at 0. Times a negative gain: bow up.
    EXPECT_NEAR(pitch.gain, -k, k * 0.02);
    EXPECT_NEAR(heave.gain, 1.0, 0.02);
    EXPECT_NEAR(wave_forcing(ShipAxis::roll, k, pi, 180.0).gain, 0.0, 1e-12);
    // A sea that travels to port (mu = 90 degrees) comes from starboard: the crest is there first, starboard
    // up.
    const WaveForcing roll = wave_forcing(ShipAxis::roll, k, pi / 2.0, 180.0);
    EXPECT_NEAR(roll.gain, k, 1e-9) << "negative before the crest: starboard up";
}

TEST(ShipAt, HeavePitchAndRollMoveTheBodyAndNotTheWaterline) {
    const ShipTrack track{.start_m = {100.0, 50.0, 0.0}, .heading_rad = 0.5, .speed_mps = 6.0};
    const ShipMotion motion(swell, large_ship_response(), 0.5, 6.0);
    const double time = 41.0;
    const ShipMotionValues values = motion.at(time);
    const MovingObject object = ship_at(track.at(time), values, {.all = 1.0, .pitch = 2.0});
    EXPECT_TRUE(object.visible);
    EXPECT_EQ(object.waterline_position_m.z, 0.0);
    EXPECT_NEAR(object.position_m.z, values[2], 1e-15);
    EXPECT_EQ(object.position_m.x, object.waterline_position_m.x);
    EXPECT_EQ(object.attitude.heading_rad, object.waterline_heading_rad);
    EXPECT_NEAR(object.waterline_heading_rad, 0.5 + values[5], 1e-15);
    EXPECT_NEAR(object.attitude.roll_rad, values[3], 1e-15);
    EXPECT_NEAR(object.attitude.pitch_rad, 2.0 * values[4], 1e-15);
    const double x = 100.0 + std::cos(0.5) * (246.0 + values[0]) - std::sin(0.5) * values[1];
    EXPECT_NEAR(object.waterline_position_m.x, x, 1e-9);
}

TEST(ShipTrack, MakesTwelveKnots) {
    const ShipTrack track{.heading_rad = heading_from_aviation(radians(90.0)),
                          .speed_mps = 12.0 * 1852.0 / 3600.0};
    EXPECT_NEAR(track.at(300.0).position_m.x, 1852.0, 1e-9);
    EXPECT_NEAR(track.at(300.0).position_m.y, 0.0, 1e-9);
}

} // namespace
} // namespace linkdig::host
