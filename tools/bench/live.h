#pragma once
/// Frames at the pace of a display, as a host sends them: how late the late ones are.

#include "tools/bench/measure.h"

namespace linkdig::bench {

struct LiveTimes {
    double rate_hz = 60.0;
    double p50_ms = 0.0; ///< packet in, pixels in memory: half of the frames take less
    double p99_ms = 0.0;
    double p999_ms = 0.0;
    double greatest_ms = 0.0;
    std::uint32_t frames = 0;
    std::uint32_t overruns = 0; ///< frames that took longer than the display's period
};

/// Draws `options.frames` frames, each begun when its turn comes, and sleeps between them.
LiveTimes measure_live(const Scene& scene, const MeasureOptions& options, double rate_hz);

} // namespace linkdig::bench
