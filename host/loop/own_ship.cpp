#include "host/loop/own_ship.h"

#include "host/motion/view.h"

#include <utility>

namespace linkdig::host {

double way_s(double time_s, const SignalValues& signals) {
    return signals[Signal::ship_speed] * time_s + signals[Signal::ship_way];
}

Pose OwnShipProgram::at(double time_s, double way_s) const {
    if (!path.values.empty()) {
        const MotionHistory::Values now = path.at(time_s);
        return {{now[0], now[1], now[2]}, {.heading_rad = now[3], .pitch_rad = now[4], .roll_rad = now[5]}};
    }
    const Steering steering = beside.at(way_s);
    const Mat3d world_from_mean = steering.world_from_mean();
    const EyeAndAim flown = approach.at(fixed ? 0.0 : time_s);
    return {steering.position_m + world_from_mean * flown.eye_m,
            looking_along(world_from_mean * (flown.aim_m - flown.eye_m))};
}

OwnShip::OwnShip(OwnShipProgram program, std::optional<HelicopterState> flown, double update_rate_hz)
    : program_(std::move(program)), begins_with_(std::move(flown)), update_rate_hz_(update_rate_hz) {}

Pose OwnShip::at(std::uint64_t frame, const SignalValues& signals) {
    if (!begins_with_ && !signals.on(Signal::hands_on)) {
        state_.reset();
        const double time_s = static_cast<double>(frame) / update_rate_hz_;
        return program_.at(time_s, way_s(time_s, signals));
    }
    if (!state_ || frame < state_frame_) take_over(frame, signals);
    const HelicopterControls controls{.stick_fore = signals[Signal::stick_fore],
                                      .stick_right = signals[Signal::stick_right],
                                      .pedals_right = signals[Signal::pedals_right],
                                      .collective = signals[Signal::collective]};
    for (; state_frame_ < frame; ++state_frame_)
        state_ = flown(*state_, controls, 1.0 / update_rate_hz_);
    return {state_->position_m, state_->attitude};
}

void OwnShip::take_over(std::uint64_t frame, const SignalValues& signals) {
    state_ = begins_with_ ? *begins_with_ : on_the_program(frame, signals);
    state_frame_ = begins_with_ ? 0 : frame;
}

HelicopterState OwnShip::on_the_program(std::uint64_t frame, const SignalValues& signals) const {
    const double time_s = static_cast<double>(frame) / update_rate_hz_;
    const double step_s = 1.0 / update_rate_hz_;
    const auto pose = [&](double at_s) { return program_.at(at_s, way_s(at_s, signals)); };
    const Pose now = pose(time_s);
    const Vec3d velocity = (pose(time_s + step_s).position_m - now.position_m) / step_s;
    return {.position_m = now.position_m, .velocity_mps = velocity, .attitude = now.attitude};
}

void OwnShip::resume(std::uint64_t frame, const std::optional<HelicopterState>& state) {
    state_ = state;
    state_frame_ = frame;
}

} // namespace linkdig::host
