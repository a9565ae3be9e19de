#pragma once
/// Rates that people change while the flight runs: what they move stays where it is, and goes on from there at its new pace.
/// Whoever writes such a signal writes the rate alone; the phase that keeps sun and ships in their places is added here.

#include "host/loop/host_loop.h"
#include "host/signals/signal_store.h"

namespace linkdig::host {

class SteadyRates {
public:
    /// The signals of the next frame, from a snapshot. Where a rate differs from the last call's, its phase is changed as well, here
    /// and in the store. `frame`: the one before it. A reset changes no phase: there is no frame before the first.
    SignalValues follow(const SignalValues& snapshot, const HostLoop& loop, std::uint64_t frame,
                        SignalStore& store);
    /// The last call gave these, as when a saved flight is taken up again.
    void resume(const SignalValues& signals) { last_ = signals; }

private:
    SignalValues last_;
};

} // namespace linkdig::host
