#include "host/packet/recording_format.h"

#include <xxhash.h>

namespace linkdig::recording_format {

std::uint64_t hash(std::span<const std::uint8_t> bytes) { return XXH64(bytes.data(), bytes.size(), 0); }

std::uint64_t record_hash(std::uint64_t number, std::uint64_t length, std::span<const std::uint8_t> bytes) {
    std::array<std::uint8_t, 24> message{};
    store(message, 0, number);
    store(message, 8, length);
    store(message, 16, hash(bytes));
    return hash(message);
}

} // namespace linkdig::recording_format
