#include "host/loop/host_values.h"

namespace linkdig::host {

namespace {

/// The state's values, in their order in the packet.
template <typename State>
auto values_of(State& state) {
    return std::array{&state.position_m.x,         &state.position_m.y,       &state.position_m.z,
                      &state.velocity_mps.x,       &state.velocity_mps.y,     &state.velocity_mps.z,
                      &state.attitude.heading_rad, &state.attitude.pitch_rad, &state.attitude.roll_rad};
}

} // namespace

void keep_host_values(const SignalValues& signals, const std::optional<HelicopterState>& own_ship,
                      FramePacket& packet) {
    packet.host_values.clear(); // keeps its memory
    // Whether packets are written is nothing that a packet says: a flight is the same with and without a recording.
    for (const SignalDefinition& each : signal_directory())
        if (signals[each.signal] != each.initial && each.signal != Signal::record)
            packet.host_values.push_back({static_cast<std::uint32_t>(each.signal), signals[each.signal]});
    if (!own_ship) return;
    std::uint32_t index = first_own_ship_value;
    for (const double* value : values_of(*own_ship))
        packet.host_values.push_back({index++, *value});
}

SignalValues signals_of(const FramePacket& packet) {
    SignalValues signals;
    for (const HostValue& each : packet.host_values)
        if (each.index < signal_count) signals.set(static_cast<Signal>(each.index), each.value);
    return signals;
}

std::optional<HelicopterState> own_ship_of(const FramePacket& packet) {
    HelicopterState state;
    const auto values = values_of(state);
    std::size_t found = 0;
    for (const HostValue& each : packet.host_values) {
        if (each.index < first_own_ship_value || each.index >= first_own_ship_value + values.size()) continue;
        *values[each.index - first_own_ship_value] = each.value;
        ++found;
    }
    if (found != values.size()) return std::nullopt;
    return state;
}

} // namespace linkdig::host
