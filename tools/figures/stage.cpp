#include "tools/figures/stage.h"

#include "database/format/name_directory.h"
#include "host/motion/view.h"
#include "tools/flight/shipped_scenes.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>

namespace linkdig::tools {
namespace {

FlightRequest request_of(const std::string& scenario, const StageOptions& options) {
    FlightRequest request;
    request.scenario_path = scenario.starts_with('/') ? scenario : shipped_scenes() + "/" + scenario;
    request.configuration = ig::modern_profile();
    request.configuration.raster.width = options.width;
    request.configuration.raster.height = options.height;
    request.configuration.edge_smoothing = options.edge_smoothing;
    request.configuration.update_rate_hz = 30.0;
    request.configuration.threads = options.threads;
    return request;
}

} // namespace

Stage::Stage(const std::string& scenario, const StageOptions& options)
    : flight_(request_of(scenario, options)),
      directory_(database::name_directory(flight_.database(), flight_.database_id())) {
    flight_.machine().draw_planes(true, true);
}

FramePacket Stage::packet(std::uint64_t frame, const host::SignalValues& signals) {
    return flight_.packet_of(frame, signals);
}

const ig::VideoFrame& Stage::draw(const FramePacket& packet) {
    const FrameReport& report = flight_.machine().frame(packet);
    if (!report.errors.empty())
        throw std::logic_error(
            fmt::format("a figure's packet was refused: {}", fmt::join(report.errors, "; ")));
    return flight_.machine().picture(0);
}

std::uint32_t Stage::sea_sun() const {
    const auto list = directory_.find_list("sea");
    return list ? directory_.lists[*list].sun : 0;
}

bool Stage::point(FramePacket& packet, const std::string& slot, std::uint32_t alternative) const {
    const auto found = directory_.find_slot(slot);
    if (!found) return false;
    std::erase_if(packet.substitutions, [&](const Substitution& each) { return each.slot == *found; });
    packet.substitutions.push_back({*found, alternative});
    return true;
}

std::uint32_t Stage::alternatives(const std::string& slot) const {
    const auto found = directory_.find_slot(slot);
    return found ? directory_.slots[*found].alternatives : 0;
}

std::size_t Stage::moving_object(const std::string& name) const {
    return directory_.find_moving_object(name).value();
}

std::vector<std::uint8_t> Stage::mask(std::span<const std::string_view> lists) const {
    const ig::Machine& machine = flight_.machine();
    const std::vector<std::int32_t>& ranks = machine.picture(0).rank;
    std::vector<std::uint8_t> mask(ranks.size(), 0);
    for (std::size_t i = 0; i < ranks.size(); ++i) {
        if (ranks[i] < 0) continue;
        const std::string& name = flight_.database().lists[machine.source(0, ranks[i]).list].name;
        mask[i] = std::ranges::any_of(lists, [&](std::string_view begin) { return name.starts_with(begin); })
                      ? 1
                      : 0;
    }
    return mask;
}

void look(FramePacket& packet, const Vec3d& eye_m, const Vec3d& aim_m, double horizontal_field_deg) {
    constexpr double aspect = 4.0 / 3.0;
    ChannelView& channel = packet.channels.front();
    channel.eye_m = eye_m;
    channel.attitude = host::looking_along(aim_m - eye_m);
    channel.right_tangent = tangent(radians(horizontal_field_deg) / 2.0);
    channel.left_tangent = -channel.right_tangent;
    channel.top_tangent = channel.right_tangent / aspect;
    channel.bottom_tangent = -channel.top_tangent;
}

void look_beside(FramePacket& packet, std::size_t moving_object, const Vec3d& eye_m, const Vec3d& aim_m,
                 double horizontal_field_deg) {
    const MovingObject& ship = packet.moving_objects[moving_object];
    const Mat3d world_from_waterline = world_from_body({.heading_rad = ship.waterline_heading_rad});
    look(packet, ship.waterline_position_m + world_from_waterline * eye_m,
         ship.waterline_position_m + world_from_waterline * aim_m, horizontal_field_deg);
}

Vec3d ray_through(const ChannelView& channel, const Mat3d& world_from_eye, double across, double down) {
    const double x = channel.left_tangent + (channel.right_tangent - channel.left_tangent) * across;
    const double y = channel.top_tangent - (channel.top_tangent - channel.bottom_tangent) * down;
    return world_from_eye[0] - x * world_from_eye[1] + y * world_from_eye[2];
}

} // namespace linkdig::tools
