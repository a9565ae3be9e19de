#pragma once
/// What the host stood at, beside a packet: the signals that are not as they began, and a flown own ship's state. A recording
/// keeps them, so that a flight can be taken up again at any of its frames.

#include "host/motion/helicopter.h"
#include "host/packet/frame_packet.h"
#include "host/signals/signals.h"

#include <optional>

namespace linkdig::host {

/// HostValue::index below this is a Signal; from here on the own ship's state, value by value.
inline constexpr std::uint32_t first_own_ship_value = 1000;

/// Replaces packet.host_values.
void keep_host_values(const SignalValues& signals, const std::optional<HelicopterState>& own_ship,
                      FramePacket& packet);

/// Values of signals that this program does not know are passed over.
SignalValues signals_of(const FramePacket& packet);
std::optional<HelicopterState> own_ship_of(const FramePacket& packet);

} // namespace linkdig::host
