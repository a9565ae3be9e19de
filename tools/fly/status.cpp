#include "tools/fly/status.h"

#include "database/model/mathematics.h"
#include "tools/fly/controls.h"

#include <fmt/format.h>

#include <cstdint>
#include <utility>

namespace linkdig::tools {
namespace {

std::uint32_t sun_of_list(std::uint32_t list, const VisualDatabase& database, const FramePacket& packet) {
    for (const ListLighting& lighting : packet.lighting)
        if (lighting.list == list) return lighting.sun;
    return database.lists[list].sun;
}

int minutes_of_day(const FramePacket& packet) {
    return static_cast<int>(60.0F * packet.time_of_day_h + 0.5F) % (24 * 60);
}

std::uint64_t edges_of(const FrameReport& report) {
    std::uint64_t edges = 0;
    for (const ChannelReport& channel : report.channels)
        edges += channel.edges;
    return edges;
}

} // namespace

double sea_sun_elevation_deg(const VisualDatabase& database, const FramePacket& packet) {
    if (database.tiles.empty()) return 0.0;
    const std::uint32_t sun = sun_of_list(database.tiles[0].list, database, packet);
    return sun < packet.suns.size() ? degrees(arc_sine(packet.suns[sun].z)) : 0.0;
}

std::vector<std::string> status_lines(const VisualDatabase& database, const FramePacket& packet,
                                      const FrameReport& report, const host::SignalValues& signals) {
    using host::Signal;
    std::vector<std::string> lines = {
        fmt::format("frame {:5}  {:6.2f} s  edges {:6}  overruns {}", packet.frame, packet.time_s,
                    edges_of(report), report.overruns),
        fmt::format("view {:5}  {:02}:{:02}  sea's sun {:2.0f} deg, x {:.2f}  smooth shading {}{}",
                    view_name(signals), minutes_of_day(packet) / 60, minutes_of_day(packet) % 60,
                    sea_sun_elevation_deg(database, packet), signals[Signal::sea_sun_rate],
                    signals.on(Signal::smooth_shading) ? "on " : "off",
                    signals.on(Signal::freeze) ? "  paused" : ""),
    };
    for (std::string& line : overload_text(report.overload))
        lines.push_back(std::move(line));
    return lines;
}

} // namespace linkdig::tools
