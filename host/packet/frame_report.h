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
        0;                   ///< facing the eye and inside the frustum, after cutting into triangles
    std::uint64_t edges = 0; ///< edges of those faces that cross a line
    std::uint64_t most_crossings_on_a_line = 0; ///< edges that span one line, seen or hidden
    std::uint64_t segments = 0;                 ///< visible runs written
    std::uint64_t most_segments_on_a_line = 0;
    std::uint64_t lights_active = 0;        ///< light points offered to the channel
    std::uint64_t lights = 0;               ///< those that shine into its picture, hidden or not
    std::uint64_t light_pixels = 0;         ///< pixels that they brighten
    std::uint64_t ambiguous_priorities = 0; ///< pairs of clusters that no plane decided
};

/// What was left out of a frame because the frames before it passed a limit, and whether this one does. All of it is
/// nought while the machine has no limits.
struct Overload {
    std::uint32_t step = 0;    ///< of the shedding order (ig/active/shedding.h) that this frame was drawn at
    double range_factor = 1.0; ///< levels of detail end at this part of their range
    std::uint64_t coarser_details = 0;  ///< details that show a coarser level than they would, or nothing
    double least_size_px = 0.0;         ///< objects that look smaller were left out
    std::uint64_t objects_left_out = 0; ///< for their size
    std::uint64_t edges_over = 0;       ///< beyond the limit, in this frame all the same
    std::uint64_t crossings_over = 0;   ///< likewise, on the busiest line
    std::uint32_t light_step = 0;       ///< every 2^light_step-th light point was there
    std::uint64_t lights_left_out = 0;  ///< of all channels together, seen or not
    std::uint64_t lights_over = 0;      ///< beyond the limit, in this frame all the same
    bool beyond_a_limit() const { return edges_over != 0 || crossings_over != 0 || lights_over != 0; }
    bool shed() const { return step != 0 || light_step != 0; }
    bool any() const { return shed() || beyond_a_limit(); }
    bool operator==(const Overload&) const = default;
};

/// In words, a line each: "levels of detail end at 0.35 of their range: 3 show less", "objects under 4 px left out: 120".
std::vector<std::string> overload_text(const Overload& overload);

/// A wake that the machine made itself.
struct WakeReport {
    std::uint32_t list = 0;
    std::uint32_t faces = 0;     ///< made, of those reserved
    std::uint64_t edges = 0;     ///< of them, on all channels
    std::uint32_t particles = 0; ///< alive
    bool operator==(const WakeReport&) const = default;
};

struct FrameReport {
    std::uint64_t frame = 0;
    std::vector<ChannelReport> channels;
    /// From the packet to the first and the last line of each field of its picture on the display, modelled.
    struct FieldDelay {
        double first_line_s = 0;
        double last_line_s = 0;
    };
    std::vector<FieldDelay> fields;
    Overload overload;
    std::vector<WakeReport> wakes;   ///< parallel to the packet's
    double wakes_s = 0.0;            ///< what making them took, measured; nothing is decided by it
    std::uint64_t overruns = 0;      ///< set by the host's frame clock
    std::vector<std::string> errors; ///< a refused packet says why here; its picture is the frame before
};

} // namespace linkdig
