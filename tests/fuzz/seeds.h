#pragma once
/// What the fuzzers begin with: sound values, from which they find their own way.

#include <cstdint>
#include <vector>

namespace linkdig::fuzz {

using Bytes = std::vector<std::uint8_t>;

std::vector<Bytes> packet_bytes_seeds();
std::vector<Bytes> packet_json_seeds();
std::vector<Bytes> database_seeds();

} // namespace linkdig::fuzz
