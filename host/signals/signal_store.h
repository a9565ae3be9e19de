#pragma once
/// Where the signals stand between two frames. Any thread may write at any time; the loop takes a snapshot
/// per frame.

#include "host/signals/signals.h"

#include <atomic>
#include <cstdint>

namespace linkdig::host {

class SignalStore {
public:
    SignalStore();
    SignalStore(const SignalStore&) = delete;
    SignalStore& operator=(const SignalStore&) = delete;

    /// Writes the admissible value. False, and nothing changes, for a NaN or an unknown name.
    bool write(Signal signal, double value);
    bool write(std::string_view name, double value);
    /// Adds to a signal and clamps the sum: what a key does that is pressed again and again. False for a NaN.
    bool add(Signal signal, double difference);
    /// The same, but beyond either bound it goes on from the other.
    bool add_round(Signal signal, double difference);
    /// A switch changes sides.
    void change_over(Signal signal);
    /// All signals back to their initial values.
    void restore();
    /// All signals but the pulses take these values, as when a saved flight is taken up again.
    void assign(const SignalValues& values);
    /// How often all signals were overwritten at once, by the two calls above: switches that stand somewhere tell their state anew.
    std::uint64_t overwritten() const { return overwritten_.load(); }

    double value(Signal signal) const;
    /// The values as they stand; pulses are taken, and stand at 0 afterwards.
    SignalValues snapshot();

private:
    static_assert(std::atomic<double>::is_always_lock_free); // who writes never keeps the loop waiting

    std::array<std::atomic<double>, signal_count> values_;
    std::atomic<std::uint64_t> overwritten_{0};
};

} // namespace linkdig::host
