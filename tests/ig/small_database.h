#pragma once
/// Small databases made in code, for tests of the machine.

#include "database/model/visual_database.h"
#include "host/packet/frame_packet.h"

namespace linkdig::ig {

/// One static list "sea" with one repeated tile of random normals at a fixed vertical angle; sun row 0.
struct SeaOptions {
    double cell_m = 12.0;
    std::uint32_t period = 64;
    std::uint32_t rings = 6;
    std::uint32_t fine_levels = 2;
    std::uint32_t half_width = 16;
    double vertical_angle_deg = 68.0;
    float ambient = 0.35F;
    float diffuse = 0.65F;
};
VisualDatabase sea_database(const SeaOptions& options = {});

/// An axis-aligned box of face-shaded faces as a cluster of its own; the colour code of all six faces is
/// `colour`. Appends group (by number, ascending order is the caller's duty), cluster, list, object, run and
/// leaf.
struct BoxOptions {
    Vec3f from{-1, -1, -1};
    Vec3f to{1, 1, 1};
    std::uint16_t colour = 0;
    std::uint32_t group = 0;
    std::int32_t moving_object = none;
};
std::uint32_t add_box(VisualDatabase& database, const BoxOptions& options); ///< index of its cluster

/// A level channel of 60 degrees looking along world x (heading 0) from `eye_m`.
ChannelView channel_at(const Vec3d& eye_m, double heading_deg = 0.0, double pitch_deg = 0.0,
                       double roll_deg = 0.0);

} // namespace linkdig::ig
