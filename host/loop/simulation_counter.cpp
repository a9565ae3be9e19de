#include "host/loop/simulation_counter.h"

namespace linkdig::host {

std::uint64_t SimulationCounter::next(const SignalValues& signals) {
    const bool advance = !signals.on(Signal::freeze) || signals.on(Signal::single_step);
    if (!started_ || signals.on(Signal::reset))
        frame_ = 0;
    else if (advance)
        ++frame_;
    started_ = true;
    return frame_;
}

} // namespace linkdig::host
