#include "tests/fuzz/targets.h"

#include "database/format/file_header.h"
#include "database/format/read.h"
#include "database/format/write.h"
#include "host/packet/check_packet.h"
#include "host/packet/packet_bytes.h"
#include "host/packet/packet_json.h"
#include "ig/machine/machine.h"

#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

namespace linkdig::fuzz {
namespace {

void require(bool holds, const char* what) {
    if (holds) return;
    std::fprintf(stderr, "fuzz: %s\n", what);
    std::abort();
}

/// The largest database that such a packet could be meant for.
PacketLimits roomy(const FramePacket& packet) {
    constexpr std::size_t many = std::size_t{1} << 31U;
    return {.suns = packet.suns.size(),
            .moving_objects = packet.moving_objects.size(),
            .lists = many,
            .colours = packet.colours.empty() ? many : packet.colours.size(),
            .clusters = many,
            .alternatives = std::vector<std::uint32_t>(64, ~std::uint32_t{0})};
}

/// A packet that a database of this shape can be drawn with: the eye looks down at its origin.
FramePacket plain_packet(const VisualDatabase& database) {
    FramePacket packet;
    packet.channels.resize(1);
    packet.channels[0].eye_m = {-30.0, 2.0, 12.0};
    packet.channels[0].attitude.pitch_rad = -0.3;
    packet.suns.assign(database.suns.size(), Vec3f(0, 0, 1));
    packet.moving_objects.resize(database.moving_objects.size());
    return packet;
}

/// Tiles of the largest sizes take memory and time in proportion to what they show, not to the file: let them pass.
bool quickly_drawn(const VisualDatabase& database) {
    std::uint64_t squares = 0;
    for (const RepeatedTile& tile : database.tiles)
        squares += std::uint64_t{tile.half_width} * tile.half_width * (tile.rings + tile.fine_levels + 1);
    return squares < 100'000;
}

void draw(const VisualDatabase& database) {
    if (!quickly_drawn(database)) return;
    for (const bool smooth : {false, true}) {
        ig::Machine machine(database,
                            {.name = "fuzz", .raster = {64, 48}, .edge_smoothing = smooth, .threads = 1});
        require(machine.frame(plain_packet(database)).errors.empty(), "the machine refuses a plain packet");
        require(machine.picture(0).pixels.size() == std::size_t{64} * 48, "there is no picture");
    }
}

} // namespace

void packet_bytes(std::span<const std::uint8_t> bytes) {
    const PacketResult first = decode_packet(bytes);
    require(first.packet.has_value() != !first.error.empty(), "neither a packet nor a reason");
    if (!first.packet) return;
    const std::vector<std::uint8_t> written = encode_packet(*first.packet);
    const PacketResult second = decode_packet(written);
    require(second.packet.has_value(), "an encoded packet is refused");
    require(encode_packet(*second.packet) == written, "a packet's bytes do not repeat");
    const std::string json = to_json(*first.packet);
    const PacketResult third = from_json(json);
    if (third.packet) require(to_json(*third.packet) == json, "a packet's JSON does not repeat");
    if (!check_packet(*first.packet, roomy(*first.packet)).empty())
        return; // JSON does not tell one NaN from another
    require(third.packet.has_value(), "a drawable packet's JSON is refused");
    require(encode_packet(*third.packet) == written, "JSON does not keep a drawable packet");
}

void packet_json(std::span<const std::uint8_t> text) {
    const std::string_view view(reinterpret_cast<const char*>(text.data()), text.size());
    const PacketResult first = from_json(view);
    require(first.packet.has_value() != !first.error.empty(), "neither a packet nor a reason");
    if (!first.packet) return;
    const PacketResult second = from_json(to_json(*first.packet));
    require(second.packet.has_value(), "a packet's own JSON is refused");
    require(encode_packet(*second.packet) == encode_packet(*first.packet), "JSON does not keep a packet");
}

void database_file(std::span<const std::uint8_t> file) {
    if (file.size() < database::header_bytes) return;
    std::vector<std::uint8_t> sealed(file.begin(), file.end());
    database::seal_header(sealed);
    const database::ReadResult read = database::decode_database(sealed);
    require(read.database.has_value() != !read.error.empty(), "neither a database nor a reason");
    if (!read.database) return;
    const database::ReadResult again = database::decode_database(database::encode_database(*read.database));
    require(again.database && *again.database == *read.database, "a database is not read as it was written");
    draw(*read.database);
}

} // namespace linkdig::fuzz
