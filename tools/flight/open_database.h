#pragma once
/// From a path in a scenario to a visual database that has passed the verifying reader.

#include "database/model/visual_database.h"

#include <cstdint>
#include <string>
#include <vector>

namespace linkdig::tools {

struct OpenedDatabase {
    VisualDatabase database;
    std::uint64_t id = 0; ///< FramePacket::database_id
};

/// Opens an .igdb file; a .toml file is compiled into one first, in a temporary folder that is gone
/// afterwards. Throws BadInput if the source has mistakes or the file is refused, std::runtime_error if the
/// temporary file cannot be written. `files` receives, in any case, every file that the result depends on.
OpenedDatabase open_database(const std::string& path, std::vector<std::string>* files = nullptr);

} // namespace linkdig::tools
