#pragma once
/// The link between host and image generator. The host knows this interface and never the image generator: behind it
/// stands the machine in process, a recording that is being written, or a network.

#include "host/packet/frame_packet.h"
#include "host/packet/frame_report.h"

namespace linkdig {

class Link {
public:
    virtual ~Link() = default;
    /// Hands over one frame's packet; returns when the picture of that packet is done (or has been queued).
    /// The report is valid until the next call.
    virtual const FrameReport& frame(const FramePacket& packet) = 0;
};

} // namespace linkdig
