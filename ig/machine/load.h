#pragma once
/// Load: counts of a frame against the machine's limits, and the step of the shedding order for the next one.
///
/// A frame beyond a limit is completed; its own counts, object by object, tell what each step would have saved, and the
/// first step that is enough, with an eighth to spare, is taken at once. A step is taken back when the counts, with all
/// that would return counted at its most, have borne it for `calm_frames` frames: so a scene that stands still never goes back
/// and forth. Light points have steps of their own; what each step leaves of the frame at hand is counted, not
/// forecast.

#include "host/packet/frame_packet.h"
#include "host/packet/frame_report.h"
#include "ig/active/face_block.h"
#include "ig/active/history.h"
#include "ig/active/light_steps.h"
#include "ig/configuration.h"
#include "ig/edges/edge.h"
#include "ig/geometry/projected_face.h"

#include <array>
#include <cstdint>
#include <vector>

namespace linkdig::ig {

inline constexpr std::uint32_t calm_frames = 16;

/// What a frame's channels add up to.
struct LoadCounts {
    std::uint64_t edges = 0;
    std::uint64_t crossings = 0;                                 ///< on the busiest line of any channel
    std::uint64_t channels = 0;                                  ///< that are on
    std::array<std::uint64_t, light_steps + 1> lights_at_step{}; ///< ProjectedFaces::lights_at_step
    std::uint64_t lights_left_out = 0;
    std::vector<std::uint64_t> object_edges; ///< parallel to VisualDatabase::objects
    /// Working storage of the forecast.
    std::vector<std::uint16_t> opacity, opacity_at_step;
    std::vector<std::uint64_t> seen_of_detail, worth_of_detail;
};

/// Edges that span the busiest line; `on_line` is working storage.
std::uint64_t most_crossings(const FaceEdges& edges, std::uint32_t lines, std::vector<std::int64_t>& on_line);

/// Adds a channel's edges to the objects that they belong to.
void count_edges(const ActiveDatabase& active, const ProjectedFaces& projected, const FaceEdges& edges,
                 LoadCounts& counts);

/// The report on a frame that was drawn at `history.load.step`, and the step for the next.
Overload settle_load(const VisualDatabase& database, const FramePacket& packet, const Capacity& capacity,
                     const ActiveDatabase& active, LoadCounts& counts, History& history);

} // namespace linkdig::ig
