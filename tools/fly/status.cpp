#include "tools/fly/status.h"

#include "database/model/mathematics.h"
#include "database/model/rotation.h"
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

std::string wakes_text(const FrameReport& report, const VisualDatabase& database) {
    std::string text = fmt::format("wakes {:.2f} ms", 1000.0 * report.wakes_s);
    for (const WakeReport& wake : report.wakes) {
        text += fmt::format("  {} {} faces {} edges", database.lists[wake.list].name, wake.faces, wake.edges);
        if (wake.particles != 0) text += fmt::format(" {} particles", wake.particles);
    }
    return text;
}

} // namespace

double sea_sun_elevation_deg(const VisualDatabase& database, const FramePacket& packet) {
    if (database.tiles.empty()) return 0.0;
    const std::uint32_t sun = sun_of_list(database.tiles[0].list, database, packet);
    return sun < packet.suns.size() ? degrees(arc_sine(packet.suns[sun].z)) : 0.0;
}

std::vector<std::string> load_lines(const Flight& flight, const FrameReport& report) {
    const FlightCosts& costs = flight.costs();
    std::vector<std::string> lines{fmt::format("{:<7} host {:.2f} ms  ig {:.2f} ms  over the period {}",
                                               flight.configuration().name, 1000.0 * costs.last_host_s,
                                               1000.0 * costs.last_machine_s, costs.over_period)};
    for (const ChannelReport& channel : report.channels)
        lines.push_back(fmt::format("faces {:6} of {:6}  edges {:6}  segments {:6}  most on a line {}",
                                    channel.faces_projected, channel.faces_active, channel.edges,
                                    channel.segments, channel.most_segments_on_a_line));
    return lines;
}

std::string stage_line(const ig::StageTimes& stages) {
    constexpr double ms = 1000.0;
    return fmt::format(
        "active {:.2f}  water {:.2f}  priority {:.2f}  geometry {:.2f}  edges {:.2f}  lights {:.2f}  "
        "bands {:.2f}  scanline {:.2f}  video {:.2f} ms",
        ms * stages.active_s, ms * stages.water_s, ms * stages.priority_s, ms * stages.geometry_s,
        ms * stages.edges_s, ms * stages.lights_s, ms * stages.bands_s, ms * stages.scanline_s,
        ms * stages.video_s);
}

std::vector<std::string> method_lines(const host::HostLoop& loop, const host::SignalValues& signals) {
    std::vector<std::string> lines;
    for (std::size_t i = 0; i < loop.ship_methods().size(); ++i) {
        const host::ShipMethods& ship = loop.ship_methods()[i];
        std::string wakes;
        for (std::size_t k = 0; k < host::wake_count; ++k)
            if (ship.shows(static_cast<host::Wake>(k), signals))
                wakes += fmt::format(" {}", host::wake_names[k]);
        lines.push_back(fmt::format("{}: occulting {}, wake{}", loop.ship_names()[i],
                                    host::occulting_names[static_cast<std::size_t>(ship.occulting(signals))],
                                    wakes.empty() ? " as modelled" : wakes));
    }
    const auto state = static_cast<std::size_t>(signals[host::Signal::sea_state]);
    lines.push_back(fmt::format("sea: {}, state {}",
                                host::sea_method_names[static_cast<std::size_t>(loop.sea_method(signals))],
                                state == 0 ? "as the scenario says" : host::sea_states[state - 1].name));
    return lines;
}

std::vector<std::string> sun_lines(const VisualDatabase& database, const FramePacket& packet) {
    std::vector<std::string> lines;
    for (std::size_t i = 0; i < packet.suns.size() && i < database.suns.size(); ++i) {
        const Vec3f& sun = packet.suns[i];
        const double azimuth = modulo(aviation_from_heading(arc_tangent(sun.y, sun.x)), two_pi);
        lines.push_back(fmt::format("sun {:<8} {:5.1f} deg, {:4.1f} up  ({:+.3f} {:+.3f} {:+.3f})",
                                    database.suns[i], degrees(azimuth), degrees(arc_sine(sun.z)), sun.x,
                                    sun.y, sun.z));
    }
    return lines;
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
    if (!report.wakes.empty()) lines.push_back(wakes_text(report, database));
    return lines;
}

} // namespace linkdig::tools
