#include "host/packet/packet_bytes.h"

#include "host/packet/stored_packet.h"

#include <fmt/format.h>

#include <stdexcept>
#include <type_traits>

namespace linkdig {

namespace {

using Builder = flatbuffers::FlatBufferBuilder;

template <typename Row>
auto stored_rows(Builder& builder, const std::vector<Row>& rows) {
    using Stored = decltype(to_stored(std::declval<const Row&>()));
    std::vector<Stored> stored;
    stored.reserve(rows.size());
    for (const Row& row : rows)
        stored.push_back(to_stored(row));
    return builder.CreateVectorOfStructs(stored);
}

struct FlatNormals {
    std::vector<stored::VertexNormalUpdate> updates;
    std::vector<Vec3f> normals;
};

FlatNormals flatten(const std::vector<VertexNormalUpdate>& updates) {
    FlatNormals flat;
    for (const VertexNormalUpdate& update : updates) {
        flat.updates.emplace_back(update.list, update.first,
                                  static_cast<std::uint32_t>(update.normals.size()));
        flat.normals.insert(flat.normals.end(), update.normals.begin(), update.normals.end());
    }
    return flat;
}

/// Not less than the packet will take.
std::uint64_t most_bytes(const FramePacket& p) {
    std::uint64_t bytes =
        1024 + p.channels.size() * sizeof(stored::ChannelView) + p.suns.size() * sizeof(Vec3f) +
        p.lighting.size() * sizeof(ListLighting) + p.moving_objects.size() * sizeof(stored::MovingObject) +
        p.substitutions.size() * sizeof(Substitution) + p.priorities.size() * sizeof(ClusterPriority) +
        p.host_values.size() * sizeof(stored::HostValue) + p.colours.size() * sizeof(Colour) +
        p.wakes.size() * sizeof(stored::WakeRequest) + p.quays.size() * sizeof(stored::Quay);
    for (const VertexNormalUpdate& update : p.normal_updates)
        bytes += sizeof(stored::VertexNormalUpdate) + update.normals.size() * sizeof(Vec3f);
    return bytes;
}

/// The normals back into their updates; false if the counts do not add up to their number.
bool unflatten(const stored::FramePacket& from, std::vector<VertexNormalUpdate>& to) {
    const auto& normals = *from.normals();
    flatbuffers::uoffset_t next = 0;
    for (const stored::VertexNormalUpdate* update : *from.normal_updates()) {
        if (update->count() > normals.size() - next) return false;
        VertexNormalUpdate& made = to.emplace_back();
        made.list = update->list();
        made.first = update->first();
        made.normals.reserve(update->count());
        for (const auto end = next + update->count(); next < end; ++next)
            made.normals.push_back(from_stored(*normals.Get(next)));
    }
    return next == normals.size();
}

/// Copies rows; false if they are not aligned, which FlatBuffers 2.0.8 does not verify.
template <typename Row, typename Stored>
bool copy_rows(const flatbuffers::Vector<const Stored*>& from, std::vector<Row>& to) {
    if (from.size() != 0 && reinterpret_cast<std::uintptr_t>(from.Data()) % alignof(Stored) != 0)
        return false;
    to.reserve(from.size());
    for (flatbuffers::uoffset_t i = 0; i < from.size(); ++i)
        to.push_back(from_stored(*from.Get(i)));
    return true;
}

bool copy_tables(const stored::FramePacket& from, FramePacket& to) {
    std::vector<Vec3f> aligned; // tells only whether the normals can be read
    return copy_rows(*from.channels(), to.channels) && copy_rows(*from.suns(), to.suns) &&
           copy_rows(*from.lighting(), to.lighting) && copy_rows(*from.moving_objects(), to.moving_objects) &&
           copy_rows(*from.substitutions(), to.substitutions) && copy_rows(*from.normals(), aligned) &&
           (from.colours() == nullptr || copy_rows(*from.colours(), to.colours)) &&
           unflatten(from, to.normal_updates) &&
           (from.priorities() == nullptr || copy_rows(*from.priorities(), to.priorities)) &&
           (from.host_values() == nullptr || copy_rows(*from.host_values(), to.host_values)) &&
           (from.wakes() == nullptr || copy_rows(*from.wakes(), to.wakes)) &&
           (from.quays() == nullptr || copy_rows(*from.quays(), to.quays));
}

void copy_numbers(const stored::FramePacket& from, FramePacket& to) {
    to.frame = from.frame();
    to.time_s = from.time_s();
    to.database_id = from.database_id();
    to.lod_bias = from.lod_bias();
    to.visibility_m = from.visibility_m();
    to.sky = from_stored(*from.sky());
    to.time_of_day_h = from.time_of_day_h();
    to.sea = from_stored(*from.sea());
    to.seed = from.seed();
    to.discontinuity = from.discontinuity();
    to.light_points = from.light_points();
}

/// `bytes` is aligned for doubles.
PacketResult decode_aligned(std::span<const std::uint8_t> bytes) {
    flatbuffers::Verifier verifier(bytes.data(), bytes.size());
    if (!stored::VerifyFramePacketBuffer(verifier))
        return {.packet = {}, .error = "damaged: the FlatBuffers verifier refuses it"};
    const stored::FramePacket& root = *stored::GetFramePacket(bytes.data());
    PacketResult result{.packet = FramePacket{}, .error = {}};
    copy_numbers(root, *result.packet);
    if (!copy_tables(root, *result.packet))
        return {.packet = {}, .error = "damaged: its tables are not aligned, or its normals do not add up"};
    return result;
}

} // namespace

std::vector<std::uint8_t> encode_packet(const FramePacket& packet) {
    if (most_bytes(packet) > max_packet_bytes)
        throw std::length_error(
            fmt::format("packet of frame {} takes more than {} MiB", packet.frame, max_packet_bytes >> 20U));
    Builder builder;
    const auto channels = stored_rows(builder, packet.channels);
    const auto suns = stored_rows(builder, packet.suns);
    const auto lighting = stored_rows(builder, packet.lighting);
    const auto moving_objects = stored_rows(builder, packet.moving_objects);
    const auto substitutions = stored_rows(builder, packet.substitutions);
    const FlatNormals flat = flatten(packet.normal_updates);
    const auto normal_updates = builder.CreateVectorOfStructs(flat.updates);
    const auto normals = stored_rows(builder, flat.normals);
    const auto colours = stored_rows(builder, packet.colours);
    // Tables that most packets leave empty are left out, so that older packets keep their bytes.
    flatbuffers::Offset<flatbuffers::Vector<const stored::ClusterPriority*>> priorities;
    if (!packet.priorities.empty()) priorities = stored_rows(builder, packet.priorities);
    flatbuffers::Offset<flatbuffers::Vector<const stored::HostValue*>> host_values;
    if (!packet.host_values.empty()) host_values = stored_rows(builder, packet.host_values);
    flatbuffers::Offset<flatbuffers::Vector<const stored::WakeRequest*>> wakes;
    if (!packet.wakes.empty()) wakes = stored_rows(builder, packet.wakes);
    flatbuffers::Offset<flatbuffers::Vector<const stored::Quay*>> quays;
    if (!packet.quays.empty()) quays = stored_rows(builder, packet.quays);
    const stored::Vec3 sky = to_stored(packet.sky);
    const stored::SeaParameters sea = to_stored(packet.sea);
    // A float or double that equals the schema's default (0) is left out, and -0 equals 0.
    builder.ForceDefaults(true);
    const auto root = stored::CreateFramePacket(
        builder, packet.frame, packet.time_s, packet.database_id, channels, suns, lighting, moving_objects,
        substitutions, normal_updates, normals, packet.lod_bias, packet.visibility_m, &sky,
        packet.time_of_day_h, &sea, packet.seed, packet.discontinuity, colours, packet.light_points,
        priorities, host_values, wakes, quays);
    stored::FinishFramePacketBuffer(builder, root);
    return {builder.GetBufferPointer(), builder.GetBufferPointer() + builder.GetSize()};
}

PacketResult decode_packet(std::span<const std::uint8_t> bytes) {
    if (bytes.size() < 2 * sizeof(flatbuffers::uoffset_t))
        return {.packet = {}, .error = fmt::format("cut short: {} bytes", bytes.size())};
    if (bytes.size() > max_packet_bytes)
        return {.packet = {}, .error = fmt::format("too large: {} bytes", bytes.size())};
    if (reinterpret_cast<std::uintptr_t>(bytes.data()) % alignof(double) == 0) return decode_aligned(bytes);
    const std::vector<std::uint8_t> aligned(bytes.begin(), bytes.end());
    return decode_aligned(aligned);
}

} // namespace linkdig
