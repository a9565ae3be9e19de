#include "database/format/file_header.h"

#include <fmt/format.h>
#include <xxhash.h>

#include <algorithm>
#include <array>
#include <cassert>

namespace linkdig::database {

namespace {

constexpr std::array<std::uint8_t, 8> magic = {'L', 'I', 'N', 'K', 'D', 'I', 'G', 0};
constexpr std::size_t version_at = 8;
constexpr std::size_t reserved_at = 12;
constexpr std::size_t length_at = 16;
constexpr std::size_t hash_at = 24;

template <typename Number>
void store(std::span<std::uint8_t> file, std::size_t at, Number number) {
    for (std::size_t i = 0; i < sizeof(Number); ++i)
        file[at + i] = static_cast<std::uint8_t>(number >> (8U * i));
}

template <typename Number>
Number load(std::span<const std::uint8_t> file, std::size_t at) {
    Number number = 0;
    for (std::size_t i = 0; i < sizeof(Number); ++i)
        number |= static_cast<Number>(static_cast<Number>(file[at + i]) << (8U * i));
    return number;
}

/// The payload's hash is its identity too; hashing that with the header's fields needs one pass, not two.
std::uint64_t hash_of_file(std::span<const std::uint8_t> file, std::uint64_t id) {
    std::array<std::uint8_t, hash_at + 8> message{};
    std::copy_n(file.begin(), hash_at, message.begin());
    store<std::uint64_t>(message, hash_at, id);
    return XXH64(message.data(), message.size(), 0);
}

} // namespace

std::uint64_t payload_id(std::span<const std::uint8_t> payload) {
    return XXH64(payload.data(), payload.size(), 0);
}

void seal_header(std::span<std::uint8_t> file) {
    assert(file.size() >= header_bytes);
    std::copy(magic.begin(), magic.end(), file.begin());
    store<std::uint32_t>(file, version_at, format_version);
    store<std::uint32_t>(file, reserved_at, 0);
    store<std::uint64_t>(file, length_at, file.size() - header_bytes);
    store<std::uint64_t>(file, hash_at, hash_of_file(file, payload_id(file.subspan(header_bytes))));
}

std::string check_header(std::span<const std::uint8_t> file) {
    if (file.empty()) return "the file is empty";
    if (file.size() < header_bytes)
        return fmt::format("cut short: {} bytes, the header alone takes {}", file.size(), header_bytes);
    if (!std::equal(magic.begin(), magic.end(), file.begin()))
        return "not a compiled visual database: it does not begin with \"LINKDIG\"";
    if (const auto version = load<std::uint32_t>(file, version_at); version != format_version)
        return fmt::format("format version {}; this program reads version {}: compile it anew", version,
                           format_version);
    if (load<std::uint32_t>(file, reserved_at) != 0)
        return "damaged: reserved bytes of the header are not zero";
    const auto length = load<std::uint64_t>(file, length_at);
    const std::uint64_t present = file.size() - header_bytes;
    if (length > present)
        return fmt::format("cut short: the header promises {} bytes, {} are there", length, present);
    if (length < present)
        return fmt::format("damaged: {} bytes follow the end that the header gives", present - length);
    return {};
}

std::string check_hash(std::span<const std::uint8_t> file, std::uint64_t& id) {
    id = payload_id(file.subspan(header_bytes));
    if (const std::uint64_t hash = hash_of_file(file, id); hash != load<std::uint64_t>(file, hash_at))
        return fmt::format("damaged: its contents hash to {:016x}, the header says {:016x}", hash,
                           load<std::uint64_t>(file, hash_at));
    return {};
}

} // namespace linkdig::database
