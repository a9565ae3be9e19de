#pragma once
/// Can a packet be drawn with a database? What the image generator asks before it draws.

#include "host/packet/frame_packet.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace linkdig {

/// What a packet's tables and indices are held against: the sizes of the database's tables.
struct PacketLimits {
    std::size_t suns = 0;           ///< FramePacket::suns has this many rows
    std::size_t moving_objects = 0; ///< FramePacket::moving_objects has this many rows
    std::size_t lists = 0;
    std::size_t colours = 0;
    std::size_t clusters = 0;
    std::vector<std::uint32_t> alternatives; ///< of each slot
    std::uint64_t database_id = 0;           ///< 0: do not check
};

PacketLimits packet_limits(const VisualDatabase& database, std::uint64_t database_id = 0);

inline constexpr std::size_t max_channels = 8;
inline constexpr double max_packet_coordinate_m = 1e7;
inline constexpr double max_tangent = 20.0;  ///< of a frustum's side: 87 degrees from the line of sight
inline constexpr double max_angle_rad = 1e6; ///< sine_cosine() is exact up to here
inline constexpr double max_time_s = 1e12;
inline constexpr double max_lod_bias = 16.0;
inline constexpr double most_wake_faces = 100000.0;
inline constexpr double most_wake_age_s = 600.0;
inline constexpr std::size_t max_quays = 64;
inline constexpr double least_quay_m = 0.01;

/// Empty: it can be drawn. Else the first thing that is wrong, by the field's name: "channels[0].eye_m is not
/// finite". Takes no memory while nothing is wrong. A slot or list that stands twice in its table takes the
/// later row.
std::string check_packet(const FramePacket& packet, const PacketLimits& limits);

} // namespace linkdig
