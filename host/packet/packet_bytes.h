#pragma once
/// Frame packets to and from bytes (recording.fbs).

#include "host/packet/frame_packet.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace linkdig {

struct PacketResult {
    std::optional<FramePacket> packet; ///< empty: refused
    std::string error;                 ///< why
};

/// No packet is longer: whoever reads one need not trust a length beyond this.
inline constexpr std::uint64_t max_packet_bytes = std::uint64_t{1} << 28U;

/// The same bytes for the same packet. Every value survives, whether check_packet() would accept it or not.
/// Throws std::length_error if the packet would pass max_packet_bytes.
std::vector<std::uint8_t> encode_packet(const FramePacket& packet);

/// Checks the structure, not whether the values make sense: that is check_packet()'s. Never crashes, and
/// takes no more memory than a small multiple of the bytes.
PacketResult decode_packet(std::span<const std::uint8_t> bytes);

} // namespace linkdig
