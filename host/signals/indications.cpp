#include "host/signals/indications.h"

#include <limits>

namespace linkdig::host {

namespace {

constexpr std::array<IndicationDefinition, indication_count> directory{{
    {Indication::deck_ready, "deck_ready", "1 while the nearest ship has lain quietly for a second"},
    {Indication::overrun, "overrun", "1 for a second after an update that came too late"},
    {Indication::overruns, "overruns", "updates left out so far"},
    {Indication::sea_state, "sea_state", "the report's sea state: 0, 1.5 (written 1-2), 3"},
    {Indication::heading, "heading", "own ship's heading, degrees clockwise from north"},
    {Indication::altitude_ft, "altitude_ft", "own ship's height above the water, feet"},
    {Indication::altitude_m, "altitude_m", "the same in metres"},
    {Indication::speed_kt, "speed_kt", "own ship's speed over the water, knots"},
    {Indication::climb_fpm, "climb_fpm", "own ship's climb, feet a minute"},
    {Indication::hour, "hour", "time of day, hours"},
    {Indication::visibility_m, "visibility_m", "visibility, metres; nothing while it is unlimited"},
    {Indication::ship_pitch, "ship_pitch", "nearest ship's pitch, degrees bow up"},
    {Indication::ship_roll, "ship_roll", "nearest ship's roll, degrees starboard down"},
    {Indication::ship_heading, "ship_heading", "nearest ship's heading, degrees clockwise from north"},
    {Indication::ship_speed_kt, "ship_speed_kt", "nearest ship's speed, knots"},
    {Indication::range_m, "range_m", "distance to the nearest ship, metres"},
    {Indication::sea_sun_height, "sea_sun_height", "height of the sea's sun above the horizon, degrees"},
    {Indication::frame, "frame", "number of the frame"},
}};

constexpr bool in_order_of_enumeration() {
    for (std::size_t i = 0; i < directory.size(); ++i)
        if (static_cast<std::size_t>(directory[i].indication) != i) return false;
    return true;
}
static_assert(in_order_of_enumeration());

} // namespace

std::span<const IndicationDefinition> indication_directory() { return directory; }

std::optional<Indication> find_indication(std::string_view name) {
    for (const IndicationDefinition& each : directory)
        if (name == each.name) return each.indication;
    return std::nullopt;
}

std::vector<std::string> indication_names() {
    std::vector<std::string> names;
    names.reserve(directory.size());
    for (const IndicationDefinition& each : directory)
        names.emplace_back(each.name);
    return names;
}

IndicationStore::IndicationStore() {
    for (std::atomic<double>& value : values_)
        value.store(std::numeric_limits<double>::quiet_NaN());
}

} // namespace linkdig::host
