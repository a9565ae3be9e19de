#pragma once
/// How long the stages of a frame took: for people who measure, never for the machine, which decides by counts alone.

#include <chrono>

namespace linkdig::ig {

/// Seconds of the last frame, all channels together. The last two are summed over the threads that draw bands.
struct StageTimes {
    double active_s = 0.0;
    double water_s = 0.0; ///< wakes that are made at frame time
    double priority_s = 0.0;
    double geometry_s = 0.0;
    double edges_s = 0.0;
    double lights_s = 0.0;
    double bands_s = 0.0; ///< sorting faces into bands
    double scanline_s = 0.0;
    double video_s = 0.0;
};

/// Adds the time until it ends to a sum, if there is one.
class StageClock {
public:
    explicit StageClock(double* sum_s) : sum_s_(sum_s) {
        if (sum_s_ != nullptr) begin_ = std::chrono::steady_clock::now();
    }
    ~StageClock() {
        if (sum_s_ != nullptr)
            *sum_s_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
    }
    StageClock(const StageClock&) = delete;
    StageClock& operator=(const StageClock&) = delete;

private:
    double* sum_s_;
    std::chrono::steady_clock::time_point begin_;
};

} // namespace linkdig::ig
