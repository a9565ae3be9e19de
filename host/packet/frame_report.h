#pragma once
/// The frame report: what the image generator tells the host about a frame.

#include <cstdint>
#include <string>
#include <vector>

namespace linkdig {

/// Counts per channel. They, never the clock, decide about load.
struct ChannelReport {
    std::uint64_t faces_active = 0; ///< offered to the channel by the active data base
    std::uint64_t faces_projected =
        0;                      ///< facing the eye and inside the frustum, after cutting into triangles
    std::uint64_t edges = 0;    ///< edges of those faces that cross a line
    std::uint64_t segments = 0; ///< visible runs written
    std::uint64_t most_segments_on_a_line = 0;
    std::uint64_t ambiguous_priorities = 0; ///< pairs of clusters that no plane decided
};

struct FrameReport {
    std::uint64_t frame = 0;
    std::vector<ChannelReport> channels;
    double first_line_delay_s =
        0; ///< from the packet to the first line of its picture on the display, modelled
    double last_line_delay_s = 0;
    std::uint64_t overruns = 0;      ///< set by the host's frame clock
    std::vector<std::string> errors; ///< a refused packet says why here; its picture is the frame before
};

} // namespace linkdig
