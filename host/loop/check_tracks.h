#pragma once
/// Does a ship's track lead through something that stands still?

#include "host/motion/track.h"
#include "host/scenario/bind.h"

namespace linkdig::host {

/// Boxes of static clusters of the ship's own priority group (a pier, a mole), if the database says where they stand, against
/// the ship's box on her track, for the whole length of the scenario. Reported where the ship stands in the scenario.
void check_track(const ShipSection& ship, const ShipTrack& track, double duration_s,
                 const NameDirectory& directory, database::Diagnostics& diagnostics);

} // namespace linkdig::host
