#pragma once
/// What the image generator remembers from frame to frame. A plain value: copy it, keep it, put it back, and the same
/// packets give the same pictures again. Everything else that the machine holds follows from packet and database.

#include "ig/active/wake_history.h"

#include <cstdint>
#include <vector>

namespace linkdig::ig {

/// How much detail overload has taken away (ig/active/shedding.h), and what the machine waits for.
struct LoadState {
    std::uint32_t step = 0;       ///< of the shedding order
    std::uint32_t calm = 0;       ///< frames in a row that would bear one step less
    std::uint32_t over = 0;       ///< frames in a row beyond a limit
    std::uint32_t light_step = 0; ///< of the shedding of light points
    std::uint32_t light_calm = 0; ///< frames in a row that would bear one light step less
    bool operator==(const LoadState&) const = default;
};

struct History {
    /// Parallel to VisualDatabase::details: the level that hysteresis holds on to; the detail's number of levels stands
    /// for nothing, beyond the last. Empty: no frame yet, or the scene jumped; ranges alone decide then.
    std::vector<std::uint32_t> held_level{};
    LoadState load{};
    std::vector<WakeTrail> trails{}; ///< of the wakes that the last packet asked for, as the next
    std::vector<ParticleWake> particle_wakes{};
    bool operator==(const History&) const = default;
};

} // namespace linkdig::ig
