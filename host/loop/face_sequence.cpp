#include "host/loop/face_sequence.h"

#include <cmath>

namespace linkdig::host {

FaceSequence FaceSequence::of(std::uint32_t alternatives, double dwell_s, double phase,
                              double update_rate_hz) {
    return {alternatives, dwell_s * update_rate_hz, phase * static_cast<double>(alternatives)};
}

std::uint32_t FaceSequence::index(std::uint64_t frame) const {
    // 0.1 s at 30 Hz must change in frame 3 although the product may lie a rounding error above 3.
    constexpr double rounding = 1e-9;
    const double faces = static_cast<double>(frame) / frames_per_face + first_face;
    const double count = static_cast<double>(alternatives);
    const double whole = std::floor(faces + rounding);
    const double face = whole - std::floor(whole / count) * count;
    return face < count ? static_cast<std::uint32_t>(face) : 0;
}

} // namespace linkdig::host
