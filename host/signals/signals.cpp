#include "host/signals/signals.h"

#include "database/model/mathematics.h"

#include <algorithm>
#include <cmath>

namespace linkdig::host {

namespace {

using enum SignalKind;

constexpr std::array<SignalDefinition, signal_count> directory{{
    {Signal::freeze, "freeze", toggle, 0, 1, 0, "", "simulated time stands still"},
    {Signal::single_step, "single_step", pulse, 0, 1, 0, "", "one frame while frozen"},
    {Signal::reset, "reset", pulse, 0, 1, 0, "", "back to the first frame"},
    {Signal::sea_sun_elevation, "sea_sun_elevation", level, -pi / 2, pi / 2, 0, "rad",
     "added to the elevation of turning suns: contrast of the sea"},
    {Signal::sea_sun_rate, "sea_sun_rate", level, 0, 8, 1, "",
     "factor on the azimuth increment of turning suns: agitation of the sea"},
    {Signal::sea_sun_azimuth, "sea_sun_azimuth", level, -two_pi, two_pi, 0, "rad",
     "added to the azimuth of turning suns"},
    {Signal::smooth_shading, "smooth_shading", toggle, 0, 1, 1, "", "smooth shading on"},
    {Signal::view, "view", selector, 0, 3, 0, "", "0 ahead, 1 left, 2 right, 3 down"},
    // The report (3.3.2) drove the ship at 10 degrees of pitch, twice the greatest of a real landing.
    {Signal::pitch_amplitude, "pitch_amplitude", level, 0, 2, 1, "", "factor on the ships' pitch"},
    {Signal::visibility, "visibility", level, 0.01, 1, 1, "", "factor on the visibility"},
    {Signal::time_of_day, "time_of_day", level, -24, 24, 0, "h", "hours added to the scenario's time of day"},
}};

constexpr bool in_order_of_enumeration() {
    for (std::size_t i = 0; i < directory.size(); ++i)
        if (static_cast<std::size_t>(directory[i].signal) != i) return false;
    return true;
}
static_assert(in_order_of_enumeration());

} // namespace

std::span<const SignalDefinition> signal_directory() { return directory; }

const SignalDefinition& definition(Signal signal) { return directory[static_cast<std::size_t>(signal)]; }

std::optional<Signal> find_signal(std::string_view name) {
    for (const SignalDefinition& each : directory)
        if (name == each.name) return each.signal;
    return std::nullopt;
}

std::vector<std::string> signal_names() {
    std::vector<std::string> names;
    names.reserve(directory.size());
    for (const SignalDefinition& each : directory)
        names.emplace_back(each.name);
    return names;
}

std::optional<double> admissible(Signal signal, double value) {
    if (std::isnan(value)) return std::nullopt;
    const SignalDefinition& defined = definition(signal);
    const double clamped = std::clamp(value, defined.minimum, defined.maximum);
    return defined.kind == level ? clamped : std::round(clamped);
}

SignalValues::SignalValues() : values_{} {
    for (std::size_t i = 0; i < signal_count; ++i)
        values_[i] = directory[i].initial;
}

void SignalValues::set(Signal signal, double value) {
    if (const auto written = admissible(signal, value)) values_[static_cast<std::size_t>(signal)] = *written;
}

} // namespace linkdig::host
