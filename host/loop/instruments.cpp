#include "host/loop/instruments.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace linkdig::host {

namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
constexpr double feet_per_m = 1.0 / 0.3048;
constexpr double knots_per_mps = 3600.0 / 1852.0;
constexpr double quiet_for_s = 1.0;

double compass_deg(double heading_rad) { return modulo(degrees(aviation_from_heading(heading_rad)), 360.0); }

} // namespace

Instruments::Instruments(const HostLoop& loop)
    : ships_(loop.ship_rows()), sea_sun_(loop.sea_sun_row()),
      frames_per_second_(static_cast<std::uint64_t>(std::lround(loop.update_rate_hz()))),
      calls_since_overrun_(frames_per_second_), ships_m_(ships_.size()), quiet_s_(ships_.size(), 0.0) {}

void Instruments::read(const HostLoop& loop, const FramePacket& packet, std::uint64_t overruns,
                       IndicationStore& store) {
    const double passed_s = begun_ ? packet.time_s - time_s_ : 0.0;
    read_own_ship(loop.own_ship(), passed_s, store);
    read_ships(packet, passed_s, store);
    read_sea(packet, store);
    read_clock(packet, overruns, store);
    time_s_ = packet.time_s;
    begun_ = true;
}

void Instruments::read_own_ship(const Pose& pose, double passed_s, IndicationStore& store) {
    store.write(Indication::heading, compass_deg(pose.attitude.heading_rad));
    store.write(Indication::altitude_m, pose.position_m.z);
    store.write(Indication::altitude_ft, pose.position_m.z * feet_per_m);
    const Vec3d moved_m = pose.position_m - own_ship_m_;
    own_ship_m_ = pose.position_m;
    if (passed_s <= 0.0) return;
    store.write(Indication::speed_kt, glm::length(Vec2d(moved_m)) / passed_s * knots_per_mps);
    store.write(Indication::climb_fpm, 60.0 * moved_m.z / passed_s * feet_per_m);
}

std::size_t Instruments::nearest(const FramePacket& packet) const {
    const auto distance_m = [&](std::uint32_t row) {
        return glm::distance(packet.moving_objects[row].position_m, own_ship_m_);
    };
    return static_cast<std::size_t>(std::ranges::min_element(ships_, {}, distance_m) - ships_.begin());
}

void Instruments::read_ships(const FramePacket& packet, double passed_s, IndicationStore& store) {
    if (ships_.empty()) return;
    const std::size_t shown = nearest(packet);
    const MovingObject& ship = packet.moving_objects[ships_[shown]];
    const double moved_m = glm::distance(ship.waterline_position_m, ships_m_[shown]);
    for (std::size_t i = 0; i < ships_.size(); ++i) {
        const MovingObject& each = packet.moving_objects[ships_[i]];
        const bool quiet = std::abs(each.attitude.pitch_rad) <= quiet_pitch_rad &&
                           std::abs(each.attitude.roll_rad) <= quiet_roll_rad;
        quiet_s_[i] = quiet && passed_s >= 0.0 ? quiet_s_[i] + passed_s : 0.0;
        ships_m_[i] = each.waterline_position_m;
    }
    store.write(Indication::deck_ready, quiet_s_[shown] >= quiet_for_s ? 1.0 : 0.0);
    store.write(Indication::ship_pitch, degrees(ship.attitude.pitch_rad));
    store.write(Indication::ship_roll, degrees(ship.attitude.roll_rad));
    store.write(Indication::ship_heading, compass_deg(ship.waterline_heading_rad));
    store.write(Indication::range_m, glm::distance(ship.position_m, own_ship_m_));
    if (passed_s > 0.0) store.write(Indication::ship_speed_kt, moved_m / passed_s * knots_per_mps);
}

void Instruments::read_sea(const FramePacket& packet, IndicationStore& store) const {
    store.write(Indication::sea_state, packet.sea.state);
    store.write(Indication::visibility_m, packet.visibility_m > 0.0F ? packet.visibility_m : nothing);
    store.write(Indication::hour, packet.time_of_day_h);
    if (sea_sun_)
        store.write(Indication::sea_sun_height,
                    degrees(arc_sine(static_cast<double>(packet.suns[*sea_sun_].z))));
}

void Instruments::read_clock(const FramePacket& packet, std::uint64_t overruns, IndicationStore& store) {
    if (overruns > overruns_)
        calls_since_overrun_ = 0;
    else
        ++calls_since_overrun_;
    overruns_ = overruns;
    store.write(Indication::overrun, calls_since_overrun_ < frames_per_second_ ? 1.0 : 0.0);
    store.write(Indication::overruns, static_cast<double>(overruns));
    store.write(Indication::frame, static_cast<double>(packet.frame));
}

} // namespace linkdig::host
