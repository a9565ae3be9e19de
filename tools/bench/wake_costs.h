#pragma once
/// What wakes that the machine makes itself cost: one flight with them and without them.

#include <cstdint>
#include <string>
#include <vector>

namespace linkdig::bench {

struct WakeCost {
    std::string made;            ///< what of wakes is made: "none", "kelvin", "wave_particles", "both"
    std::uint64_t faces = 0;     ///< of wakes, of the last frame
    std::uint64_t particles = 0; ///< alive in it
    std::uint64_t edges = 0;     ///< of the whole frame, all channels
    double making_ms = 0.0;      ///< of a frame, the report's; medians
    double frame_ms = 0.0;       ///< packet in, pixels in memory, the wakes' making with it
};

/// Flies the two ships' figure of eight from its 100th second on, with each choice in turn, frame by frame.
std::vector<WakeCost> compare_wakes(std::uint32_t size, std::uint32_t threads, bool smoothing,
                                    std::uint32_t frames);

} // namespace linkdig::bench
