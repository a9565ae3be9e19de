#pragma once
/// The shipped figure of eight as packets, with a picture so small that a test can draw many.

#include "database/model/visual_database.h"
#include "host/packet/frame_packet.h"

#include <vector>

namespace linkdig::ig {

struct WakeFlight {
    VisualDatabase database;
    std::vector<FramePacket> packets;
};

/// `count` packets from a time on, `rate_hz` a second.
WakeFlight wake_flight(double from_s, std::size_t count, double rate_hz);

} // namespace linkdig::ig
