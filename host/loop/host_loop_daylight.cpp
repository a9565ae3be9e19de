/// HostLoop's hour: colours, light and lamps by the time of day.

#include "host/loop/host_loop.h"

#include <algorithm>

namespace linkdig::host {

void HostLoop::remember_day(const Scenario& scenario, const NameDirectory& directory,
                            const Binding& binding) {
    day_.hour = scenario.time_of_day_h;
    day_.hours_per_s = scenario.hours_per_minute / 60.0;
    day_.lamps_by_day = scenario.lamps_by_day;
    day_.sky = scenario.sky;
    day_.colours = directory.colour_codes;
    day_.bands = binding.sky_bands;
    packet_.colours.reserve(day_.colours.size());
}

void HostLoop::pass_day(const SignalValues& signals) {
    const double hour =
        modulo(day_.hour + day_.hours_per_s * packet_.time_s + signals[Signal::time_of_day], 24.0);
    const Daylight light = daylight(hour);
    packet_.time_of_day_h = static_cast<float>(hour);
    packet_.light_points = static_cast<float>(day_.lamps_by_day + (1.0 - day_.lamps_by_day) * light.lamps);
    for (const ShipMethods& ship : methods_)
        ship.put_lights(light.full_day, packet_);
    packet_.sky = day_.sky;
    packet_.colours.clear(); // keeps its memory
    if (light.full_day) return;
    packet_.sky = Vec3f(sky_levels(light, 255.0 * Vec3d(day_.sky), 0.0) / 255.0);
    colour(light);
    dim(light, signals);
}

void HostLoop::colour(const Daylight& light) {
    for (const Colour code : day_.colours)
        packet_.colours.push_back(tinted(light, code));
    const double highest = std::max(1.0, static_cast<double>(day_.bands.size()) - 1.0);
    for (std::size_t band = 0; band < day_.bands.size(); ++band) {
        const std::uint32_t code = day_.bands[band];
        packet_.colours[code] = sky_colour(light, day_.colours[code], static_cast<double>(band) / highest);
    }
}

/// Every list but the sky's loses sunlight.
void HostLoop::dim(const Daylight& light, const SignalValues& signals) {
    packet_.lighting.assign(without_smoothing_.begin(), without_smoothing_.end());
    for (ListLighting& list : packet_.lighting) {
        const ListLight dimmed = under(light, list.ambient, list.diffuse);
        list.ambient = dimmed.ambient;
        list.diffuse = dimmed.diffuse;
        if (signals.on(Signal::smooth_shading)) list.method = ShadingMethod::as_modelled;
    }
}

} // namespace linkdig::host
