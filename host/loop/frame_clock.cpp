#include "host/loop/frame_clock.h"

#include <chrono>
#include <cmath>
#include <stdexcept>
#include <thread>

namespace linkdig::host {

namespace {

class SteadyTime final : public TimeSource {
public:
    double now_s() override { return std::chrono::duration<double>(Clock::now() - origin_).count(); }
    void sleep_until(double time_s) override {
        std::this_thread::sleep_until(
            origin_ + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(time_s)));
    }

private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point origin_ = Clock::now();
};

} // namespace

std::unique_ptr<TimeSource> steady_time() { return std::make_unique<SteadyTime>(); }

FrameClock::FrameClock(double rate_hz) : rate_hz_(rate_hz) {
    if (!(rate_hz > 0.0) || !std::isfinite(rate_hz))
        throw std::invalid_argument("the frame clock's rate must be a finite number above 0");
}

FrameClock::FrameClock(double rate_hz, TimeSource& time) : FrameClock(rate_hz) { time_ = &time; }

double FrameClock::due_s(std::uint64_t slot) const { return start_s_ + static_cast<double>(slot) / rate_hz_; }

void FrameClock::restart() { next_ = 0; }

std::uint64_t FrameClock::wait() {
    if (time_ == nullptr) return next_++;
    const double now = time_->now_s();
    if (next_ == 0) {
        start_s_ = now;
        return next_++;
    }
    if (now <= due_s(next_)) {
        time_->sleep_until(due_s(next_));
        return next_++;
    }
    std::uint64_t running = next_;
    const double slots_since_start = std::floor((now - start_s_) * rate_hz_);
    if (slots_since_start > static_cast<double>(next_))
        running = static_cast<std::uint64_t>(slots_since_start);
    overruns_ += running - next_;
    next_ = running + 1;
    return running;
}

} // namespace linkdig::host
