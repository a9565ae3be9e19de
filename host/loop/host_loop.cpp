#include "host/loop/host_loop.h"

#include "host/loop/host_values.h"
#include "host/loop/turned_normals.h"
#include "host/motion/view.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace linkdig::host {

const FramePacket& HostLoop::packet(std::uint64_t frame, const SignalValues& signals) {
    packet_.frame = frame;
    packet_.time_s = static_cast<double>(frame) / update_rate_hz_;
    packet_.discontinuity = frame == 0;
    turn_suns(frame, signals);
    move_ships(packet_.time_s, signals);
    point_slots(frame, signals);
    look(frame, signals);
    shade(signals);
    see(signals);
    pass_day(signals);
    keep_host_values(signals, own_ship_.state(), packet_);
    return packet_;
}

SunPosition HostLoop::sea_sun(const TurningSun& sun, std::uint64_t frame, const SignalValues& signals) const {
    SunPosition position = sun.sun.position(frame, signals[Signal::sea_sun_rate],
                                            signals[Signal::sea_sun_elevation_rate] / update_rate_hz_,
                                            signals[Signal::sea_sun_elevation_phase]);
    if (const auto state = static_cast<std::size_t>(signals[Signal::sea_state]); state != 0)
        position.elevation_rad = std::clamp(
            radians(sea_states[state - 1].elevation_deg) + signals[Signal::sea_sun_elevation], 0.0, pi / 2.0);
    else
        position.elevation_rad = std::clamp(position.elevation_rad + signals[Signal::sea_sun_elevation],
                                            sun.sun.least_elevation_rad, sun.sun.greatest_elevation_rad);
    position.azimuth_rad += signals[Signal::sea_sun_azimuth];
    return position;
}

void HostLoop::turn_suns(std::uint64_t frame, const SignalValues& signals) {
    for (const TurningSun& each : sea_suns_)
        packet_.suns[each.row] = sun_vector(sea_sun(each, frame, signals));
    for (const TurningSun& each : other_suns_)
        packet_.suns[each.row] = sun_vector(each.sun.position(frame));
    const auto state = static_cast<std::size_t>(signals[Signal::sea_state]);
    packet_.sea.state = state == 0 ? sea_state_ : static_cast<float>(sea_states[state - 1].state);
    if (sea_method(signals) == SeaMethod::normals)
        turn_the_normals(frame, signals);
    else if (!packet_.normal_updates.empty()) {
        sea_update_ = std::move(packet_.normal_updates.front()); // with its memory
        packet_.normal_updates.clear();
    }
}

SeaMethod HostLoop::sea_method(const SignalValues& signals) const {
    if (!can_turn_normals() || !signals.on(Signal::sea_method)) return sea_method_;
    return sea_method_ == SeaMethod::sun ? SeaMethod::normals : SeaMethod::sun;
}

/// The sun stays where it is and the normals turn the other way: n . s is the same.
void HostLoop::turn_the_normals(std::uint64_t frame, const SignalValues& signals) {
    const auto same = [&](const TurningSun& each) { return each.row == sea_sun_row_; };
    const auto sun = std::ranges::find_if(sea_suns_, same);
    if (sun == sea_suns_.end()) return;
    const auto asked = static_cast<std::uint64_t>(signals[Signal::normals_every]);
    const std::uint64_t every = asked != 0 ? asked : normals_every_;
    SunPosition held = sea_sun(*sun, frame / every * every, signals);
    if (packet_.normal_updates.empty()) packet_.normal_updates.push_back(std::move(sea_update_));
    turn_normals(sea_normals_, sun->sun.initial.azimuth_rad - held.azimuth_rad,
                 packet_.normal_updates.front());
    held.azimuth_rad = sun->sun.initial.azimuth_rad;
    packet_.suns[sun->row] = sun_vector(held);
}

/// A ship that slows down keeps her motion in the seaway: its table or its waves go on with the clock, only her way does not.
void HostLoop::move_ships(double time_s, const SignalValues& signals) {
    const MotionFactors factors{.all = signals[Signal::ship_motion],
                                .pitch = signals[Signal::pitch_amplitude]};
    for (const Ship& each : ships_) {
        const Steering steering = each.track.at(way_s(time_s, signals));
        packet_.moving_objects[each.row] = ship_at(steering, each.mover.at(time_s, steering), factors);
    }
}

void HostLoop::point_slots(std::uint64_t frame, const SignalValues& signals) {
    packet_.substitutions.clear(); // keeps its memory
    packet_.priorities.clear();
    packet_.wakes.clear();
    for (const Pointer& each : pointers_)
        packet_.substitutions.push_back({each.slot, each.sequence.index(frame)});
    for (std::size_t i = 0; i < ships_.size(); ++i) {
        const MovingObject& ship = packet_.moving_objects[ships_[i].row];
        methods_[i].put(ship, signals, frame, packet_);
        methods_[i].roll_cams(ship, signals, frame, packet_);
        const double speed_mps =
            signals[Signal::ship_speed] * ships_[i].track.speed_at(way_s(packet_.time_s, signals));
        methods_[i].put_made_wakes(signals, speed_mps, packet_);
    }
}

void HostLoop::look(std::uint64_t frame, const SignalValues& signals) {
    pose_ = own_ship_.at(frame, signals);
    const Attitude head =
        mounted(pose_.attitude, view_offsets[static_cast<std::size_t>(signals[Signal::view])]);
    for (std::size_t i = 0; i < packet_.channels.size(); ++i) {
        packet_.channels[i].eye_m = pose_.position_m;
        packet_.channels[i].attitude = mounted(head, mounts_[i]);
    }
}

void HostLoop::resume(const FramePacket& packet) { own_ship_.resume(packet.frame, own_ship_of(packet)); }

void HostLoop::shade(const SignalValues& signals) {
    packet_.lighting.clear(); // keeps its memory
    if (signals.on(Signal::smooth_shading)) return;
    packet_.lighting.assign(without_smoothing_.begin(), without_smoothing_.end());
}

void HostLoop::see(const SignalValues& signals) {
    // A scenario without limit has a factor all the same: it then counts from a clear day's (estimated).
    constexpr double clear_day_m = 50000.0;
    const double factor = signals[Signal::visibility];
    const double full_m = visibility_m_ > 0.0 || factor >= 1.0 ? visibility_m_ : clear_day_m;
    packet_.visibility_m = static_cast<float>(full_m * factor);
}

SignalValues HostLoop::with_sea_sun_rate(const SignalValues& signals, double rate,
                                         std::uint64_t frame) const {
    SignalValues changed = signals;
    changed.set(Signal::sea_sun_rate, rate);
    if (sea_suns_.empty()) return changed;
    const OceanSun& sun = sea_suns_.front().sun;
    const double before = sun.position(frame, signals[Signal::sea_sun_rate]).azimuth_rad;
    const double after = sun.position(frame, changed[Signal::sea_sun_rate]).azimuth_rad;
    changed.set(Signal::sea_sun_azimuth, modulo(signals[Signal::sea_sun_azimuth] + before - after, two_pi));
    return changed;
}

SignalValues HostLoop::with_ship_speed(const SignalValues& signals, double factor,
                                       std::uint64_t frame) const {
    SignalValues changed = signals;
    changed.set(Signal::ship_speed, factor);
    const double time_s = static_cast<double>(frame) / update_rate_hz_;
    const double lost = signals[Signal::ship_speed] - changed[Signal::ship_speed];
    changed.set(Signal::ship_way, signals[Signal::ship_way] + lost * time_s);
    return changed;
}

std::vector<std::uint32_t> HostLoop::ship_rows() const {
    std::vector<std::uint32_t> rows;
    rows.reserve(ships_.size());
    for (const Ship& each : ships_)
        rows.push_back(each.row);
    return rows;
}

SignalValues HostLoop::with_sea_sun_elevation_rate(const SignalValues& signals, double rate_rad_s,
                                                   std::uint64_t frame) const {
    SignalValues changed = signals;
    changed.set(Signal::sea_sun_elevation_rate, rate_rad_s);
    const double per_frame =
        (signals[Signal::sea_sun_elevation_rate] - changed[Signal::sea_sun_elevation_rate]) / update_rate_hz_;
    changed.set(Signal::sea_sun_elevation_phase,
                signals[Signal::sea_sun_elevation_phase] + per_frame * static_cast<double>(frame));
    return changed;
}

} // namespace linkdig::host
