#pragma once
/// The 32 bytes before the FlatBuffers payload of a compiled visual database. All numbers little-endian.
///
///   0  8  magic
///   8  4  format version
///  12  4  reserved, zero
///  16  8  length of the payload in bytes; the file ends with it
///  24  8  xxHash64 (seed 0) of bytes 0 to 23 followed by the payload's own xxHash64 (seed 0)
///
/// The hash covers every other byte of the file, so that no bit of it can be changed unnoticed.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace linkdig::database {

inline constexpr std::size_t header_bytes = 32;
/// Raised whenever the meaning of a stored byte changes: a reader refuses every version but its own.
inline constexpr std::uint32_t format_version = 3;
/// FlatBuffers offsets are 32 bits with sign; half of their range is some five million faces.
inline constexpr std::uint64_t max_payload_bytes = std::uint64_t{1} << 30U;

/// Writes the header for what follows it in `file` (at least header_bytes long) into its first bytes.
void seal_header(std::span<std::uint8_t> file);

/// Empty if `file` begins with a header of this version that gives its length; else what is wrong with it.
std::string check_header(std::span<const std::uint8_t> file);

/// Empty if the hash in the header of `file`, which check_header() has passed, is that of its bytes; else what is wrong.
/// `id`: the database's identity: hashing takes a share of opening a large file, once is enough.
std::string check_hash(std::span<const std::uint8_t> file, std::uint64_t& id);

/// The database's identity: xxHash64 (seed 0) of a payload.
std::uint64_t payload_id(std::span<const std::uint8_t> payload);

} // namespace linkdig::database
