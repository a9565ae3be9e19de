#pragma once
/// A ship's six motions in a seaway as sums of sinusoids. Synthetic: the responses are simple estimates, not
/// measured tables of any ship.

#include "host/motion/seaway.h"
#include "host/motion/track.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace linkdig::host {

enum class ShipAxis : std::uint8_t { surge, sway, heave, roll, pitch, yaw };
inline constexpr std::size_t ship_axes = 6;

/// How an axis follows what the waves do to it.
struct AxisResponse {
    double gain = 1.0;
    double natural_period_s = 0.0; ///< 0: follows at once, without resonance
    double damping = 0.5;          ///< of the critical damping, > 0 where there is a natural period
    double limit = 0.0;            ///< metres or radians that the motion never exceeds
};

struct ShipResponse {
    double length_m = 180.0; ///< waves shorter than the ship average out over it
    std::array<AxisResponse, ship_axes> axes;
    AxisResponse& operator[](ShipAxis axis) { return axes[static_cast<std::size_t>(axis)]; }
    const AxisResponse& operator[](ShipAxis axis) const { return axes[static_cast<std::size_t>(axis)]; }
};

/// Estimated response of a ship of LPH-2's size, and the limits of a real landing: pitch 5, roll 8 degrees
/// (report, 3.3.1).
ShipResponse large_ship_response();

/// amplitude cos(frequency t + phase)
struct Harmonic {
    double amplitude = 0.0;
    double frequency_rad_s = 0.0;
    double phase_rad = 0.0;
};

/// Surge forward, sway to port, heave up in metres; roll starboard down, pitch bow up, yaw counter-clockwise
/// in radians.
using ShipMotionValues = std::array<double, ship_axes>;

class ShipMotion {
public:
    ShipMotion() = default; ///< at rest
    /// The motion of a ship on a straight course through a seaway.
    ShipMotion(const Seaway& seaway, const ShipResponse& response, double heading_rad, double speed_mps);

    /// The motion at a time; a pure function. |time| up to 100,000 s.
    ShipMotionValues at(double time_s) const;

    const std::vector<Harmonic>& harmonics(ShipAxis axis) const {
        return harmonics_[static_cast<std::size_t>(axis)];
    }

private:
    std::array<std::vector<Harmonic>, ship_axes> harmonics_;
};

/// The motion of a ship whose course changes: the same waves and responses as ShipMotion, the phase of each wave taken where she
/// is and her answer to it on the course that she is on (quasi-steady: what the course was before plays no part). On a straight
/// course it is ShipMotion's.
class CurvedMotion {
public:
    CurvedMotion() = default;
    CurvedMotion(const Seaway& seaway, const ShipResponse& response, double speed_mps);
    bool empty() const { return waves_.empty(); }
    /// A pure function. |time| up to 100,000 s.
    ShipMotionValues at(double time_s, const Steering& steering) const;

private:
    std::vector<WaveComponent> waves_;
    ShipResponse response_;
    double travel_heading_rad_ = 0.0;
    double speed_mps_ = 0.0;
};

/// What one wave of unit amplitude does to an axis, before the axis responds: contour of the water and path
/// of its particles at the ship, averaged over the ship's length; `quadrature` a quarter period behind cos(we
/// t - phase).
struct WaveForcing {
    double gain = 0.0; ///< metres or radians per metre of wave amplitude, signed
    bool quadrature = false;
};
WaveForcing wave_forcing(ShipAxis axis, double wave_number_rad_m, double mu_rad, double length_m);

/// A linear oscillator's answer to a forcing of angular frequency `frequency_rad_s`.
struct Oscillation {
    double gain = 1.0;
    double lag_rad = 0.0;
};
Oscillation oscillation(const AxisResponse& response, double frequency_rad_s);

} // namespace linkdig::host
