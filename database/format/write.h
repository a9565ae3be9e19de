#pragma once
/// Writes a compiled visual database.

#include "database/model/visual_database.h"

#include <cstdint>
#include <string>
#include <vector>

namespace linkdig::database {

/// The bytes of a `.igdb` file: the same for the same value, on every machine. Does not validate:
/// write_database does. Throws std::length_error if the payload would pass max_payload_bytes.
std::vector<std::uint8_t> encode_database(const VisualDatabase& database);

/// Writes a file under a temporary name in the same folder, then renames it: whoever opens `path` finds the
/// old file or the new one, never a part. Throws std::runtime_error, naming path and reason, if the database
/// would be refused when read or the file cannot be written; nothing is left behind then.
void write_database(const VisualDatabase& database, const std::string& path);

/// The identity that read_database gives for the database's file, without writing one.
std::uint64_t database_id(const VisualDatabase& database);

} // namespace linkdig::database
