#include "tools/compare/packet_difference.h"

#include "host/packet/json_writer.h"
#include "host/packet/packet_json.h"
#include "ig/machine/machine.h"

#include <fmt/format.h>

#include <algorithm>

namespace linkdig::compare {
namespace {

constexpr std::size_t most_fields_tried = 64;

/// A point or a direction: its components belong together, a sun of one's x and another's y is no unit vector.
bool is_vector(const Json& value) {
    return value.is_array() && value.size() == 3 &&
           std::ranges::none_of(value, [](const Json& each) { return each.is_structured(); });
}

void compare_values(const std::string& path, const Json& a, const Json& b,
                    std::vector<FieldDifference>& fields) {
    if (a == b) return;
    if (a.is_object() && b.is_object()) {
        for (const auto& [key, value] : a.items())
            if (b.contains(key)) compare_values(path.empty() ? key : path + "." + key, value, b[key], fields);
        return;
    }
    if (a.is_array() && b.is_array() && a.size() == b.size() && !is_vector(a)) {
        for (std::size_t k = 0; k < a.size(); ++k)
            compare_values(fmt::format("{}[{}]", path, k), a[k], b[k], fields);
        return;
    }
    if (a.is_array() && b.is_array() && !is_vector(a))
        fields.push_back({path, fmt::format("{} rows", a.size()), fmt::format("{} rows", b.size())});
    else
        fields.push_back({path, a.dump(), b.dump()});
}

Json json_of_packet(const FramePacket& packet) {
    Json json = json_of(packet);
    json.erase("database_id");
    return json;
}

/// "channels[0].eye_m[2]" as nlohmann's pointer "/channels/0/eye_m/2".
Json::json_pointer pointer_of(const std::string& field) {
    std::string pointer = "/";
    for (const char c : field) {
        if (c == '[' || c == '.')
            pointer += '/';
        else if (c != ']')
            pointer += c;
    }
    return Json::json_pointer(pointer);
}

std::vector<std::uint32_t> pixels_of(const FramesOf& frames_of, const ig::History& history,
                                     const FramePacket& packet, std::uint32_t channel) {
    ig::Machine machine(*frames_of.database, frames_of.configuration);
    machine.restore(history);
    const FrameReport& report = machine.frame(packet);
    return report.errors.empty() ? machine.picture(channel).pixels : std::vector<std::uint32_t>{};
}

} // namespace

std::vector<FieldDifference> differing_fields(const FramePacket& expected, const FramePacket& actual) {
    std::vector<FieldDifference> fields;
    compare_values("", json_of_packet(expected), json_of_packet(actual), fields);
    return fields;
}

void bisect(const FramePacket& expected, const FramePacket& actual, const FramesOf& frames_of,
            const ig::History& history, std::uint32_t channel, std::vector<FieldDifference>& fields) {
    const Json from = json_of_packet(actual);
    const Json base = json_of_packet(expected);
    const auto before = pixels_of(frames_of, history, expected, channel);
    for (std::size_t k = 0; k < std::min(fields.size(), most_fields_tried); ++k) {
        const auto pointer = pointer_of(fields[k].field);
        Json changed = base;
        changed[pointer] = from[pointer];
        const PacketResult packet = from_json(changed.dump());
        if (!packet.packet) continue;
        const auto after = pixels_of(frames_of, history, *packet.packet, channel);
        fields[k].changes_picture =
            !after.empty() && after != before; // empty: refused without its neighbours
    }
}

} // namespace linkdig::compare
