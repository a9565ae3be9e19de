#pragma once
/// Shipped scenarios as packets.

#include "database/model/visual_database.h"
#include "host/packet/frame_packet.h"

#include <cstdint>
#include <string>
#include <vector>

namespace linkdig::ig {

struct ShippedFlight {
    VisualDatabase database;
    std::vector<FramePacket> packets;
};

/// These frames of a scenario of database/scenes, `rate_hz` a second. What cannot be loaded is a failure, and gives no packets.
ShippedFlight shipped_flight(const std::string& scenario, double rate_hz,
                             const std::vector<std::uint64_t>& frames);

/// The figure of eight: `count` packets from a time on.
ShippedFlight wake_flight(double from_s, std::size_t count, double rate_hz);

} // namespace linkdig::ig
