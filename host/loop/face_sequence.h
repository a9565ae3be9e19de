#pragma once
/// The pointer that substitutes one face for the next after a fixed number of frames (report, 3.2.2).

#include <cstdint>

namespace linkdig::host {

struct FaceSequence {
    std::uint32_t alternatives = 1; ///< 28 faces of a bow wake
    double frames_per_face =
        1.0;                 ///< > 0; need not be whole: faces then alternate between the numbers around it
    double first_face = 0.0; ///< on which face it stands in frame 0, 0 to alternatives

    /// A sequence whose faces stay for a time, at an update rate; phase is a fraction of the whole sequence.
    static FaceSequence of(std::uint32_t alternatives, double dwell_s, double phase, double update_rate_hz);

    /// The face of a frame, 0 to alternatives - 1; after the last comes the first. A pure function.
    std::uint32_t index(std::uint64_t frame) const;
};

} // namespace linkdig::host
