#include "host/signals/signals.h"

#include "database/model/mathematics.h"

#include <algorithm>
#include <cmath>
#include <utility>

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
    {Signal::sea_sun_elevation_rate, "sea_sun_elevation_rate", level, -0.5, 0.5, 0, "rad/s",
     "added to the elevation rate of turning suns: Figure 7's other increment"},
    {Signal::sea_sun_elevation_phase, "sea_sun_elevation_phase", level, -1e6, 1e6, 0, "rad",
     "added to their elevation before it is reflected between its limits"},
    {Signal::sea_state, "sea_state", selector, 0, 3, 0, "",
     "0 as the scenario says, 1 state 0, 2 state 1-2, 3 state 3"},
    // A change-over turns round what the scenario says, so that 0 is always the scenario's own way.
    {Signal::sea_method, "sea_method", toggle, 0, 1, 0, "",
     "change-over: the sea's sun turns, or its normals do"},
    {Signal::normals_every, "normals_every", selector, 0, 60, 0, "",
     "frames between updates of the normals; 0 as the scenario says"},
    {Signal::occulting, "occulting", selector, 0, 6, 0, "",
     "0 as the scenario says, else none, waterline, priority, box, fitted_box, wedges"},
    {Signal::white_v, "white_v", toggle, 0, 1, 0, "", "change-over of this wake"},
    {Signal::blended_v, "blended_v", toggle, 0, 1, 0, "", "change-over of this wake"},
    {Signal::cam, "cam", toggle, 0, 1, 0, "", "change-over of this wake"},
    {Signal::face_substitution, "face_substitution", toggle, 0, 1, 0, "", "change-over of this wake"},
    {Signal::solid, "solid", toggle, 0, 1, 0, "", "change-over of this wake"},
    {Signal::churned, "churned", toggle, 0, 1, 0, "", "change-over of this wake"},
    {Signal::ship_motion, "ship_motion", level, 0, 2, 1, "", "factor on all motions of the ships"},
    {Signal::hands_on, "hands_on", toggle, 0, 1, 0, "", "the own ship is flown by hand from here"},
    {Signal::stick_fore, "stick_fore", level, -1, 1, 0, "", "stick: nose down"},
    {Signal::stick_right, "stick_right", level, -1, 1, 0, "", "stick: starboard down"},
    {Signal::pedals_right, "pedals_right", level, -1, 1, 0, "", "pedals: nose to starboard"},
    {Signal::collective, "collective", level, -1, 1, 0, "", "up"},
    {Signal::ship_speed, "ship_speed", level, 0, 2, 1, "", "factor on the ships' speeds"},
    {Signal::ship_way, "ship_way", level, -1e6, 1e6, 0, "s",
     "added to the time that the ships are under way"},
    {Signal::record, "record", toggle, 0, 1, 0, "", "packets are written to a recording"},
    {Signal::channel_select, "channel_select", selector, 0, 7, 0, "",
     "channel that the window shows; beyond the scenario's the last"},
    {Signal::kelvin, "kelvin", toggle, 0, 1, 0, "", "change-over of this wake"},
    {Signal::wave_particles, "wave_particles", toggle, 0, 1, 0, "", "change-over of this wake"},
}};

/// What people call some of them who know only one sun and one sea.
constexpr std::array<std::pair<const char*, Signal>, 3> other_names{
    {{"sun_elevation", Signal::sea_sun_elevation},
     {"sun_rate", Signal::sea_sun_rate},
     {"occulting_method", Signal::occulting}}};

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
    for (const auto& [other, signal] : other_names)
        if (name == other) return signal;
    return std::nullopt;
}

std::vector<std::string> signal_names() {
    std::vector<std::string> names;
    names.reserve(directory.size() + other_names.size());
    for (const SignalDefinition& each : directory)
        names.emplace_back(each.name);
    for (const auto& [other, signal] : other_names)
        names.emplace_back(other);
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
