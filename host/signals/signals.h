#pragma once
/// The named signals between the people at the controls and the host loop: keyboard, joystick and panels
/// write them, the loop reads them once per frame. The directory is fixed, and only ever grows at its end: recordings name
/// signals by their place in it. Initial values mean "as the scenario says".

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace linkdig::host {

enum class Signal : std::uint8_t {
    freeze,
    single_step,
    reset,
    sea_sun_elevation,
    sea_sun_rate,
    sea_sun_azimuth,
    smooth_shading,
    view,
    pitch_amplitude,
    visibility,
    time_of_day,
    sea_sun_elevation_rate,
    sea_sun_elevation_phase,
    sea_state,
    sea_method,
    normals_every,
    occulting,
    white_v,
    blended_v,
    cam,
    face_substitution,
    solid,
    churned,
    ship_motion,
    hands_on,
    stick_fore,
    stick_right,
    pedals_right,
    collective,
    ship_speed,
    ship_way,
    record,
    channel_select,
    kelvin,
    wave_particles,
};
inline constexpr std::size_t signal_count = 35;

enum class SignalKind : std::uint8_t {
    toggle,   ///< 0 or 1 (a switch)
    level,    ///< any value from minimum to maximum
    selector, ///< a whole number from minimum to maximum
    pulse,    ///< 1 until the next snapshot takes it, which leaves 0
};

struct SignalDefinition {
    Signal signal;
    const char* name;
    SignalKind kind;
    double minimum;
    double maximum;
    double initial;
    const char* unit;    ///< "rad", "h", or "" for a factor or a choice
    const char* meaning; ///< one clause, as shown in a list of signals
};

/// All signals, in the order of the enumeration.
std::span<const SignalDefinition> signal_directory();
const SignalDefinition& definition(Signal signal);
/// By its name in the directory, or by a shorter one that people use: sun_elevation, sun_rate, occulting_method.
std::optional<Signal> find_signal(std::string_view name);
std::vector<std::string> signal_names();

/// The value that the signal takes when `value` is written: clamped to its bounds; rounded if it is a switch,
/// a pulse or a selector. Nothing if the value is not a number.
std::optional<double> admissible(Signal signal, double value);

/// What all signals stood at when a frame began: a plain value.
class SignalValues {
public:
    SignalValues(); ///< initial values
    double operator[](Signal signal) const { return values_[static_cast<std::size_t>(signal)]; }
    bool on(Signal signal) const { return (*this)[signal] >= 0.5; }
    /// Writes an admissible value; a NaN leaves the signal as it was.
    void set(Signal signal, double value);
    bool operator==(const SignalValues&) const = default;

private:
    std::array<double, signal_count> values_;
};

} // namespace linkdig::host
