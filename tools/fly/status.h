#pragma once
/// The two lines of figures at the foot of the window.

#include "host/packet/frame_packet.h"
#include "host/packet/frame_report.h"
#include "host/signals/signals.h"

#include <string>
#include <vector>

namespace linkdig::tools {

/// Elevation above the horizon of the sun that lights the sea (the first list of a repeated tile), degrees; 0
/// if the database has no such list.
double sea_sun_elevation_deg(const VisualDatabase& database, const FramePacket& packet);

/// First line: what the machine did for this packet. Second line: what the keys have set.
std::vector<std::string> status_lines(const VisualDatabase& database, const FramePacket& packet,
                                      const FrameReport& report, const host::SignalValues& signals);

} // namespace linkdig::tools
