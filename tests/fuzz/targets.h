#pragma once
/// What is fuzzed: each takes any bytes and must neither crash nor find a contradiction (it aborts if it does).

#include <cstdint>
#include <span>

namespace linkdig::fuzz {

/// A frame packet's bytes: what is taken must be encoded to bytes that are taken again, and to JSON that is read back.
void packet_bytes(std::span<const std::uint8_t> bytes);

/// A frame packet's JSON: what is taken must be written as JSON that is read back to the same bytes.
void packet_json(std::span<const std::uint8_t> text);

/// A compiled database, its length and hash put right first. What the reader takes must be written and read again, and is
/// drawn for a frame.
void database_file(std::span<const std::uint8_t> file);

} // namespace linkdig::fuzz
