#pragma once
/// Frame packets to and from JSON, so that a host in any language can make one.
///
/// Fields are named as in frame_packet.h. Vectors are arrays of three numbers, `database_id` and `seed`
/// strings of hexadecimal digits ("0x1f", for JSON readers that hold numbers as doubles; integers are taken,
/// too), `method` "as_modelled" or "no_smooth", `colour` -1 for none. Numbers that are not finite are the
/// strings "nan", "inf",
/// "-inf". Fields left out have their defaults, but `frame` and the indices that say what a row is about are
/// required; unknown fields and fields that stand twice are mistakes.

#include "host/packet/packet_bytes.h"

#include <string>
#include <string_view>

namespace linkdig {

/// On one line, without the new line at its end. Reading it back gives the same bits.
std::string to_json(const FramePacket& packet);

/// Refuses with the field's name: "channels[0].eye_m: expected an array of three numbers".
PacketResult from_json(std::string_view text);

} // namespace linkdig
