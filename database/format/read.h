#pragma once
/// Reads a compiled visual database: header and hash first, then the FlatBuffers verifier, then every index
/// and number (validate.h). A damaged or hostile file is refused with a reason; what is returned can be used
/// without further checks.

#include "database/model/visual_database.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace linkdig::database {

struct ReadResult {
    std::optional<VisualDatabase> database; ///< empty: refused
    std::uint64_t id = 0;                   ///< xxHash64 of the payload: FramePacket::database_id
    std::string error; ///< why it was refused; from read_database it begins with the path
};

/// Memory taken is a small multiple of the file's size, whatever the file says.
ReadResult read_database(const std::string& path);
ReadResult decode_database(std::span<const std::uint8_t> file);

} // namespace linkdig::database
