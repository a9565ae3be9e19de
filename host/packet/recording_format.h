#pragma once
/// Numbers and hashes of a recording file, as recording.h describes it.

#include <array>
#include <cstdint>
#include <span>

namespace linkdig::recording_format {

inline constexpr std::array<std::uint8_t, 8> magic = {'L', 'I', 'N', 'K', 'R', 'E', 'C', 0};
inline constexpr std::uint32_t version = 2;
inline constexpr std::uint32_t most_path_bytes = 65536;
inline constexpr std::size_t header_bytes = 40;
inline constexpr std::size_t record_header_bytes = 16;
inline constexpr std::uint64_t end_length = ~std::uint64_t{0};
inline constexpr double max_update_rate_hz = 10000.0;

template <typename Number>
void store(std::span<std::uint8_t> bytes, std::size_t at, Number number) {
    for (std::size_t i = 0; i < sizeof(Number); ++i)
        bytes[at + i] = static_cast<std::uint8_t>(number >> (8U * i));
}

template <typename Number>
Number load(std::span<const std::uint8_t> bytes, std::size_t at) {
    Number number = 0;
    for (std::size_t i = 0; i < sizeof(Number); ++i)
        number |= static_cast<Number>(static_cast<Number>(bytes[at + i]) << (8U * i));
    return number;
}

std::uint64_t hash(std::span<const std::uint8_t> bytes);
std::uint64_t record_hash(std::uint64_t number, std::uint64_t length, std::span<const std::uint8_t> bytes);

} // namespace linkdig::recording_format
