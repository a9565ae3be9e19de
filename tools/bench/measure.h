#pragma once
/// What a frame of a scene costs on this machine.

#include "ig/configuration.h"
#include "ig/machine/machine.h"
#include "ig/machine/stage_times.h"
#include "tools/bench/scene.h"

#include <cstdint>
#include <vector>

namespace linkdig::bench {

struct MeasureOptions {
    std::uint32_t size = 1024; ///< of the picture's sides; the ames scene is 4 by 3
    std::uint32_t threads = 1;
    bool smoothing = false;
    double visibility_m = 0.0; ///< 0: unlimited
    std::uint32_t frames = 60;
    std::uint32_t channels =
        0; ///< views of the scene, each turned by 45 degrees from the one before; 0: the scene's own
};

struct Measurement {
    double median_ms = 0.0; ///< packet in, pixels in memory, all channels
    double least_ms = 0.0;
    double greatest_ms = 0.0;
    ig::StageTimes stages;   ///< means, seconds
    std::uint64_t faces = 0; ///< of the last frame, all channels
    std::uint64_t edges = 0;
    std::uint64_t segments = 0;
};

ig::Configuration configuration_of(const Scene& scene, const MeasureOptions& options);

/// The packet of a frame with the options' visibility and channels.
FramePacket packet_of(const Scene& scene, const MeasureOptions& options, std::uint64_t frame);

/// Draws a frame; throws std::runtime_error, naming it, if the machine refuses its packet: nothing would be measured.
const FrameReport& drawn(ig::Machine& machine, const FramePacket& packet);

/// Flies `frames` frames after a few to warm up.
Measurement measure(const Scene& scene, const MeasureOptions& options);

/// Median of a list that is not empty.
double median(std::vector<double> values);

/// Milliseconds to fill a frame of `pixels` with one value: what no renderer can beat.
double fill_ms(std::size_t pixels);

} // namespace linkdig::bench
