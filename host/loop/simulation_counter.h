#pragma once
/// The number of the simulated frame: it advances with every update, unless somebody freezes, steps or resets
/// it.

#include "host/signals/signals.h"

#include <cstdint>

namespace linkdig::host {

class SimulationCounter {
public:
    /// The frame to show in this update, `slots` of the frame clock after the one before: late frames are left out, so that
    /// simulated time keeps up with the clock. The first call gives 0, and so does a reset; while frozen the number stays, except
    /// for a single step.
    std::uint64_t next(const SignalValues& signals, std::uint64_t slots = 1);
    /// The next call gives the frame after this one.
    void resume(std::uint64_t frame) {
        frame_ = frame;
        started_ = true;
    }
    std::uint64_t frame() const { return frame_; } ///< what the last call gave

private:
    std::uint64_t frame_ = 0;
    bool started_ = false;
};

} // namespace linkdig::host
