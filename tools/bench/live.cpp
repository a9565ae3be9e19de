#include "tools/bench/live.h"

#include <algorithm>
#include <chrono>
#include <thread>

namespace linkdig::bench {

namespace {

using Clock = std::chrono::steady_clock;

/// The value below which this part of an ascending list lies.
double quantile(const std::vector<double>& ascending, double part) {
    const auto last = static_cast<double>(ascending.size() - 1);
    return ascending[static_cast<std::size_t>(part * last + 0.5)];
}

} // namespace

LiveTimes measure_live(const Scene& scene, const MeasureOptions& options, double rate_hz) {
    ig::Machine machine(scene.database, configuration_of(scene, options));
    std::vector<double> times_ms;
    const std::chrono::duration<double> period(1.0 / rate_hz);
    const Clock::time_point start = Clock::now();
    for (std::uint32_t frame = 0; frame < options.frames; ++frame) {
        std::this_thread::sleep_until(start + std::chrono::duration_cast<Clock::duration>(period * frame));
        const FramePacket packet = packet_of(scene, options, frame);
        const Clock::time_point begin = Clock::now();
        drawn(machine, packet);
        times_ms.push_back(std::chrono::duration<double, std::milli>(Clock::now() - begin).count());
    }
    std::ranges::sort(times_ms);
    LiveTimes result{.rate_hz = rate_hz, .frames = options.frames};
    result.p50_ms = quantile(times_ms, 0.5);
    result.p99_ms = quantile(times_ms, 0.99);
    result.p999_ms = quantile(times_ms, 0.999);
    result.greatest_ms = times_ms.back();
    result.overruns = static_cast<std::uint32_t>(
        std::ranges::count_if(times_ms, [&](double ms) { return ms > 1e3 / rate_hz; }));
    return result;
}

} // namespace linkdig::bench
