#pragma once
/// What the image generator remembers from frame to frame. A plain value: copy it, keep it, put it back, and the same
/// packets give the same pictures again. Everything else that the machine holds follows from packet and database.

#include <cstdint>
#include <vector>

namespace linkdig::ig {

struct History {
    /// Parallel to VisualDatabase::details: the level that hysteresis holds on to; the detail's number of levels stands
    /// for nothing, beyond the last. Empty: no frame yet, or the scene jumped; ranges alone decide then.
    std::vector<std::uint32_t> held_level;
    bool operator==(const History&) const = default;
};

} // namespace linkdig::ig
