#pragma once
/// Puts a whole file in the place of another.

#include <cstdint>
#include <span>
#include <string>

namespace linkdig::database {

/// Writes `bytes` under a temporary name beside `path` and renames it to `path`. Throws std::runtime_error,
/// naming path and reason; the temporary file is removed then.
void replace_file(const std::string& path, std::span<const std::uint8_t> bytes);

} // namespace linkdig::database
