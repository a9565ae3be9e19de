#include "host/loop/simulation_counter.h"

namespace linkdig::host {

std::uint64_t SimulationCounter::next(const SignalValues& signals, std::uint64_t slots) {
    const bool frozen = signals.on(Signal::freeze);
    if (!started_ || signals.on(Signal::reset))
        frame_ = 0;
    else if (!frozen)
        frame_ += slots;
    else if (signals.on(Signal::single_step))
        ++frame_;
    started_ = true;
    return frame_;
}

} // namespace linkdig::host
