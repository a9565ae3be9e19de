#include "host/packet/packet_json.h"

#include "host/packet/json_reader.h"
#include "host/packet/json_writer.h"

namespace linkdig {

std::string to_json(const FramePacket& packet) { return json_of(packet).dump(); }

PacketResult from_json(std::string_view text) {
    try {
        PacketResult result{.packet = FramePacket{}, .error = {}};
        read_value(parse_json(text), "", *result.packet);
        return result;
    } catch (const JsonMistake& mistake) {
        return {.packet = {}, .error = mistake.what()};
    }
}

} // namespace linkdig
