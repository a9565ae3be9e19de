#pragma once
/// Two recordings, packet by packet and field by field.

#include "host/packet/frame_packet.h"
#include "tools/compare/recording.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace linkdig::compare {

struct FieldDifference {
    std::string field; ///< "channels[0].eye_m"
    std::string expected;
    std::string actual;
    bool changes_picture = false; ///< see bisect()
};

/// Fields that differ, in the order of the packet. Empty for equal packets; database ids do not count.
std::vector<FieldDifference> differing_fields(const FramePacket& expected, const FramePacket& actual);

/// Which of the fields change the picture when they alone are taken from the actual packet? Marks them, at
/// most the first 64. Draws with what the expected recording is drawn with; `history`: of its machine before the packet.
void bisect(const FramePacket& expected, const FramePacket& actual, const FramesOf& frames_of,
            const ig::History& history, std::uint32_t channel, std::vector<FieldDifference>& fields);

/// What a comparison of two recordings says of their packets.
struct PacketComparison {
    bool compared = false;
    std::uint64_t differing = 0; ///< packets
    /// Of the first packet that differs:
    std::optional<std::uint64_t> first;
    std::vector<FieldDifference> fields;
    /// Of the first packet whose picture differs, if its fields do; marked by bisect().
    std::optional<std::uint64_t> first_picture;
    std::vector<FieldDifference> picture_fields;
};

} // namespace linkdig::compare
