#pragma once
/// When the next frame is due. The schedule is absolute: frame slot k is due at start + k / rate, and a late
/// frame delays none after it.

#include <cstdint>
#include <memory>

namespace linkdig::host {

/// Where a clock has its time from; tests have one of their own.
class TimeSource {
public:
    virtual ~TimeSource() = default;
    virtual double now_s() = 0;                  ///< from an arbitrary origin, never running backwards
    virtual void sleep_until(double time_s) = 0; ///< returns at once if that is past
};

/// The steady clock of the machine, from the time of the call.
std::unique_ptr<TimeSource> steady_time();

class FrameClock {
public:
    /// A virtual clock: every frame is due as soon as it is asked for, and none is ever late.
    explicit FrameClock(double rate_hz);
    /// A real clock. The time source must outlive it. Throws std::invalid_argument if the rate is not above
    /// 0.
    FrameClock(double rate_hz, TimeSource& time);

    /// Waits for the next slot and returns its number. The first call starts the clock and returns 0. A call
    /// that comes after its slot has ended skips to the slot that is running, and counts one overrun for each
    /// slot left out.
    std::uint64_t wait();

    /// Slots left out so far.
    std::uint64_t overruns() const { return overruns_; }
    /// Starts anew at the next wait(), as after a pause in which nobody waited; the count of overruns stays.
    void restart();

    double rate_hz() const { return rate_hz_; }

private:
    double due_s(std::uint64_t slot) const;
    double rate_hz_;
    TimeSource* time_ = nullptr; ///< none: virtual
    double start_s_ = 0.0;
    std::uint64_t next_ = 0;
    std::uint64_t overruns_ = 0;
};

} // namespace linkdig::host
