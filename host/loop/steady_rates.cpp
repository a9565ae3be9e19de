#include "host/loop/steady_rates.h"

#include <array>
#include <utility>

namespace linkdig::host {

namespace {

using Change = SignalValues (HostLoop::*)(const SignalValues&, double, std::uint64_t) const;

struct Rate {
    Signal rate;
    Signal phase;
    Change change;
};
constexpr std::array rates{Rate{Signal::sea_sun_rate, Signal::sea_sun_azimuth, &HostLoop::with_sea_sun_rate},
                           Rate{Signal::sea_sun_elevation_rate, Signal::sea_sun_elevation_phase,
                                &HostLoop::with_sea_sun_elevation_rate},
                           Rate{Signal::ship_speed, Signal::ship_way, &HostLoop::with_ship_speed}};

} // namespace

SignalValues SteadyRates::follow(const SignalValues& snapshot, const HostLoop& loop, std::uint64_t frame,
                                 SignalStore& store) {
    SignalValues followed = snapshot;
    for (const Rate& each : rates) {
        const double asked = snapshot[each.rate];
        if (asked == last_[each.rate] || snapshot.on(Signal::reset)) continue;
        followed.set(each.rate, last_[each.rate]);
        followed = (loop.*each.change)(followed, asked, frame);
        store.write(each.phase, followed[each.phase]);
    }
    last_ = followed;
    return followed;
}

} // namespace linkdig::host
