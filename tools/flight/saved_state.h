#pragma once
/// A flight at one of its frames, in a file: a recording of that one packet, with the image generator's history before it. The
/// packet carries what the host stood at (host/loop/host_values.h).

#include "tools/flight/flight.h"

#include <cstdint>
#include <string>
#include <vector>

namespace linkdig::tools {

struct SavedState {
    FramePacket packet;
    std::vector<std::uint8_t> history;
};

/// Saves the flight as it stood before its last draw(): `history` is that of the image generator then. Throws
/// std::runtime_error, naming the file, if it cannot.
void save_state(const std::string& path, const Flight& flight, const std::vector<std::uint8_t>& history);

/// Throws BadInput if the file is no saved state, or one of another database.
SavedState load_state(const std::string& path, std::uint64_t database_id);

} // namespace linkdig::tools
