#pragma once
/// The effects that can be switched one by one while the flight goes on, each with its price.

#include "host/loop/host_loop.h"
#include "tools/flight/flight.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace linkdig::tools {

enum class Effect : std::uint8_t {
    smooth_shading,
    haze,
    ship_motion,
    turned_normals, ///< instead of a turning sun
    box,
    fitted_box,
    wedges,
    white_v,
    blended_v,
    cam,
    face_substitution,
    solid,
    churned,
    kelvin,
    particles,
};
inline constexpr std::size_t effect_count = 15;

const char* effect_name(Effect effect);

/// Is the effect to be seen? False as well where the database has not what it needs.
bool is_on(Effect effect, const host::SignalValues& signals, const host::HostLoop& loop);
/// Has the database what the effect needs?
bool is_possible(Effect effect, const host::HostLoop& loop);
/// The signals with the effect on or off, and everything else as it was.
host::SignalValues switched(Effect effect, bool on, const host::SignalValues& signals,
                            const host::HostLoop& loop);

/// What a frame takes more with an effect than without it.
struct Price {
    std::int64_t edges = 0;
    double host_ms = 0.0; ///< the shortest of several tries, as is the next
    double ig_ms = 0.0;
};

/// Draws a frame several times with the effect and without it; the last picture is that of `signals`.
Price price_of(Effect effect, Flight& flight, std::uint64_t frame, const host::SignalValues& signals);

/// "churned            on   +1234 edges  host +0.01 ms  ig +0.80 ms"
std::string effect_line(Effect effect, const host::SignalValues& signals, const host::HostLoop& loop,
                        const std::optional<Price>& price);

} // namespace linkdig::tools
