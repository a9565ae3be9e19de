#pragma once
/// The two lines of figures at the foot of the window.

#include "host/packet/frame_packet.h"
#include "host/packet/frame_report.h"
#include "host/signals/signals.h"
#include "ig/machine/stage_times.h"
#include "tools/flight/flight.h"

#include <string>
#include <vector>

namespace linkdig::tools {

/// Elevation above the horizon of the sun that lights the sea (the first list of a repeated tile), degrees; 0
/// if the database has no such list.
double sea_sun_elevation_deg(const VisualDatabase& database, const FramePacket& packet);

/// What the last frame cost: host and image generator in milliseconds, edges, segments, crossings; a line per channel.
std::vector<std::string> load_lines(const Flight& flight, const FrameReport& report);

/// The machine's load, stage by stage, in milliseconds; of scanline and video, which threads share, the sum over the threads.
std::string stage_line(const ig::StageTimes& stages);

/// Each ship's occulting and wakes, and how the sea moves.
std::vector<std::string> method_lines(const host::HostLoop& loop, const host::SignalValues& signals);

/// Each row of the packet's table of sun vectors: azimuth clockwise from north, and elevation.
std::vector<std::string> sun_lines(const VisualDatabase& database, const FramePacket& packet);

/// First line: what the machine did for this packet. Second line: what the keys have set.
std::vector<std::string> status_lines(const VisualDatabase& database, const FramePacket& packet,
                                      const FrameReport& report, const host::SignalValues& signals);

} // namespace linkdig::tools
