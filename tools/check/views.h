#pragma once
/// Views to check a database from: a pure function of seed and number, so that a finding can be looked at again.

#include "database/model/visual_database.h"
#include "host/packet/frame_packet.h"

#include <cstdint>
#include <string>

namespace linkdig::tools {

/// How far moving objects go in the views (EST: what the scenarios' ship motion never exceeds).
inline constexpr double greatest_pitch_deg = 5.0;
inline constexpr double greatest_roll_deg = 8.0;
inline constexpr double greatest_heave_m = 2.0;

struct CheckView {
    std::uint64_t number = 0;
    FramePacket packet; ///< one channel
    std::string target; ///< what the view is aimed at
    std::string range;  ///< "near", "around" or "far"
};

/// View `number`: moving objects placed apart from each other and from what stands, with seeded attitudes; every slot on
/// a seeded alternative; the eye near, around or far from one thing after the other, outside of solids and above every
/// ground. `aspect` is width / height.
CheckView check_view(const VisualDatabase& database, std::uint64_t seed, std::uint64_t number, double aspect);

} // namespace linkdig::tools
