#pragma once
/// The own ship: on an approach, at a fixed place, on a recorded path, or flown by hand.

#include "host/motion/approach_path.h"
#include "host/motion/helicopter.h"
#include "host/motion/motion_history.h"
#include "host/motion/track.h"
#include "host/signals/signals.h"

#include <cstdint>
#include <optional>

namespace linkdig::host {

struct Pose {
    Vec3d position_m{0};
    Attitude attitude;
};

/// What flies her while nobody has the hands on: at most one of the three.
struct OwnShipProgram {
    ApproachPath approach; ///< in the mean frame of `beside`
    ShipTrack beside;      ///< by default the world: a track from its origin, heading east, that stands still
    MotionHistory path;    ///< not empty: position in the world, heading, pitch, roll
    bool fixed = false;    ///< the approach's first point and aim for ever

    /// `way_s`: the time that the ship beside has been under way.
    Pose at(double time_s, double way_s) const;
};

/// How long the ships have been under way at a time: as long, unless somebody has changed their speed.
double way_s(double time_s, const SignalValues& signals);

class OwnShip {
public:
    OwnShip() = default;
    /// `flown`: she is flown by hand from the first frame on, whatever the signals say, and begins with this state.
    OwnShip(OwnShipProgram program, std::optional<HelicopterState> flown, double update_rate_hz);

    /// Where she is in a frame. By hand her state is carried from frame to frame: frames in between are flown with the signals
    /// of now, and an earlier frame begins the flight anew.
    Pose at(std::uint64_t frame, const SignalValues& signals);

    /// The state while she is flown by hand.
    const std::optional<HelicopterState>& state() const { return state_; }
    /// Takes up the flight at a frame with a state, or with the program.
    void resume(std::uint64_t frame, const std::optional<HelicopterState>& state);

private:
    void take_over(std::uint64_t frame, const SignalValues& signals);
    HelicopterState on_the_program(std::uint64_t frame, const SignalValues& signals) const;

    OwnShipProgram program_;
    std::optional<HelicopterState> begins_with_;
    double update_rate_hz_ = 60.0;
    std::optional<HelicopterState> state_;
    std::uint64_t state_frame_ = 0;
};

} // namespace linkdig::host
