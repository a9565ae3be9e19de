#pragma once
/// Stage 2, the water: wakes that the packet asks for become faces of the active data base.

#include "host/packet/frame_packet.h"
#include "host/packet/frame_report.h"
#include "ig/active/face_block.h"
#include "ig/active/history.h"
#include "ig/water/particle_wake.h"
#include "ig/water/wake_trail.h"

#include <memory>
#include <vector>

namespace linkdig::ig {

/// What making wakes takes: memory and hulls. Nothing in it but memory outlives a frame.
struct WakeMakers {
    std::vector<std::unique_ptr<ParticleWakeMaker>> particles; ///< one of a list
    std::vector<WakeRow> rows;
};

/// Brings the wakes' part of the history up to the packet, which must have passed check_packet. A wake that a packet does not ask for
/// is forgotten.
void follow_wakes(const VisualDatabase& database, const FramePacket& packet, WakeMakers& makers,
                  History& history);

/// Fills the blocks that activate() opened for the packet's wakes; follow_wakes() comes before it. A report per wake, without its
/// edges.
void make_wake_faces(const FramePacket& packet, History& history, WakeMakers& makers, ActiveDatabase& active,
                     std::vector<WakeReport>& reports);

} // namespace linkdig::ig
