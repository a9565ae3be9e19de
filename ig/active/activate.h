#pragma once
/// Stage 1, the active data base: what exists this frame, after substitution and motion (report, 3.2.2).

#include "host/packet/frame_packet.h"
#include "ig/active/face_block.h"
#include "ig/active/history.h"
#include "ig/configuration.h"

namespace linkdig::ig {

/// Fills `active` for the packet, which must have passed check_packet, and brings `history` up to this frame. Substituted alternatives, invisible
/// moving objects and empty lists are left out here; what lies outside a channel's frustum is left to
/// geometry.
void activate(const VisualDatabase& database, const FramePacket& packet, const Configuration& configuration,
              History& history, ActiveDatabase& active);

} // namespace linkdig::ig
