#include "host/loop/host_loop.h"

#include "host/motion/view.h"

#include <algorithm>
#include <cmath>

namespace linkdig::host {

const FramePacket& HostLoop::packet(std::uint64_t frame, const SignalValues& signals) {
    packet_.frame = frame;
    packet_.time_s = static_cast<double>(frame) / update_rate_hz_;
    packet_.discontinuity = frame == 0;
    turn_suns(frame, signals);
    move_ships(packet_.time_s, signals);
    point_slots(frame);
    look(packet_.time_s, signals);
    shade(signals);
    see(signals);
    pass_day(signals);
    return packet_;
}

void HostLoop::turn_suns(std::uint64_t frame, const SignalValues& signals) {
    for (const TurningSun& each : turning_suns_) {
        SunPosition position = each.sun.position(frame, signals[Signal::sea_sun_rate]);
        position.azimuth_rad += signals[Signal::sea_sun_azimuth];
        position.elevation_rad = std::clamp(position.elevation_rad + signals[Signal::sea_sun_elevation],
                                            each.sun.least_elevation_rad, each.sun.greatest_elevation_rad);
        packet_.suns[each.row] = sun_vector(position);
    }
}

void HostLoop::move_ships(double time_s, const SignalValues& signals) {
    for (const Ship& each : ships_)
        packet_.moving_objects[each.row] =
            ship_at(each.track, each.motion, time_s, signals[Signal::pitch_amplitude]);
}

void HostLoop::point_slots(std::uint64_t frame) {
    for (std::size_t i = 0; i < pointers_.size(); ++i)
        packet_.substitutions[i].index = pointers_[i].sequence.index(frame);
}

void HostLoop::look(double time_s, const SignalValues& signals) {
    const ShipTrack& track = ships_[approached_].track;
    const Mat3d world_from_mean = track.world_from_mean();
    const EyeAndAim flown = approach_.at(time_s);
    const Vec3d eye_m = track.position_m(time_s) + world_from_mean * flown.eye_m;
    const Attitude own_ship = looking_along(world_from_mean * (flown.aim_m - flown.eye_m));
    const Attitude head = mounted(own_ship, view_offsets[static_cast<std::size_t>(signals[Signal::view])]);
    for (std::size_t i = 0; i < packet_.channels.size(); ++i) {
        packet_.channels[i].eye_m = eye_m;
        packet_.channels[i].attitude = mounted(head, mounts_[i]);
    }
}

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
    if (turning_suns_.empty()) return changed;
    const OceanSun& sun = turning_suns_.front().sun;
    const double before = sun.position(frame, signals[Signal::sea_sun_rate]).azimuth_rad;
    const double after = sun.position(frame, changed[Signal::sea_sun_rate]).azimuth_rad;
    changed.set(Signal::sea_sun_azimuth, modulo(signals[Signal::sea_sun_azimuth] + before - after, two_pi));
    return changed;
}

} // namespace linkdig::host
