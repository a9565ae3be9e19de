#include "host/packet/packet_bytes.h"

#include "database/model/random.h"
#include "host/packet/recording_generated.h"
#include "tests/host/packet/sample_packet.h"

#include <gtest/gtest.h>

#include <limits>

namespace linkdig {

namespace {

using Bytes = std::vector<std::uint8_t>;

TEST(PacketBytes, GiveBackTheSameBits) {
    for (const FramePacket& packet : {sample_packet(), FramePacket{}}) {
        const Bytes bytes = encode_packet(packet);
        const PacketResult decoded = decode_packet(bytes);
        ASSERT_TRUE(decoded.packet) << decoded.error;
        EXPECT_EQ(difference(*decoded.packet, packet), "");
        EXPECT_EQ(encode_packet(*decoded.packet), bytes);
    }
}

// What a packet is compared by must itself notice: each field changed alone.
TEST(PacketBytes, TheComparisonNotices) {
    FramePacket other = sample_packet();
    other.sea.current_north_mps = 0.30000004F;
    EXPECT_NE(difference(other, sample_packet()), "");
    other = sample_packet();
    other.channels[0].eye_m.y = 0.0; // was -0
    EXPECT_NE(difference(other, sample_packet()), "");
}

TEST(PacketBytes, KeepZerosSignAndWhatIsNoNumber) {
    FramePacket packet;
    packet.time_s = -0.0;
    packet.lod_bias = -0.0F;
    packet.visibility_m = std::numeric_limits<float>::infinity();
    packet.sky.x = std::numeric_limits<float>::quiet_NaN();
    const PacketResult decoded = decode_packet(encode_packet(packet));
    ASSERT_TRUE(decoded.packet) << decoded.error;
    EXPECT_EQ(difference(*decoded.packet, packet), "");
}

TEST(PacketBytes, AreReadAtAnyAddress) {
    const Bytes bytes = encode_packet(sample_packet());
    for (std::size_t shift = 0; shift < 8; ++shift) {
        Bytes moved(shift, 0);
        moved.insert(moved.end(), bytes.begin(), bytes.end());
        const PacketResult decoded = decode_packet(std::span(moved).subspan(shift));
        ASSERT_TRUE(decoded.packet) << decoded.error;
        EXPECT_EQ(difference(*decoded.packet, sample_packet()), "") << shift;
    }
}

TEST(PacketBytes, CutShortAreRefusedOrHarmless) {
    const Bytes bytes = encode_packet(sample_packet());
    for (std::size_t length = 0; length < bytes.size(); ++length) {
        const Bytes cut(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(length));
        const PacketResult decoded = decode_packet(cut);
        EXPECT_NE(decoded.packet.has_value(), !decoded.error.empty()) << length;
    }
    EXPECT_EQ(decode_packet({}).error, "cut short: 0 bytes");
    EXPECT_EQ(decode_packet(std::span(bytes).first(40)).error,
              "damaged: the FlatBuffers verifier refuses it");
}

TEST(PacketBytes, DamagedAreRefusedOrHarmless) {
    const Bytes sound = encode_packet(sample_packet());
    int refused = 0;
    int checked = 0;
    for (std::uint64_t seed = 0; seed < 2000; ++seed) {
        Bytes bytes = sound;
        for (std::uint64_t i = 0; i < 1 + seed % 4; ++i) {
            const std::size_t at = random_bits(seed, 2 * i) % bytes.size();
            bytes[at] = static_cast<std::uint8_t>(random_bits(seed, 2 * i + 1));
        }
        const PacketResult decoded = decode_packet(bytes);
        EXPECT_NE(decoded.packet.has_value(), !decoded.error.empty()) << seed;
        refused += decoded.packet ? 0 : 1;
        if (decoded.packet) checked += check_packet(*decoded.packet, sample_limits()).empty() ? 0 : 1;
    }
    EXPECT_GT(refused, 50);
    EXPECT_GT(checked, 50);
}

/// A packet whose counts of normals are as given, with three normals in all.
PacketResult with_counts(const std::vector<std::uint32_t>& counts) {
    flatbuffers::FlatBufferBuilder builder;
    std::vector<stored::VertexNormalUpdate> updates;
    for (const std::uint32_t count : counts)
        updates.emplace_back(0U, 0U, count);
    const auto channels = builder.CreateVectorOfStructs(std::vector<stored::ChannelView>{});
    const auto suns = builder.CreateVectorOfStructs(std::vector<stored::Vec3>{});
    const auto lighting = builder.CreateVectorOfStructs(std::vector<stored::ListLighting>{});
    const auto objects = builder.CreateVectorOfStructs(std::vector<stored::MovingObject>{});
    const auto substitutions = builder.CreateVectorOfStructs(std::vector<stored::Substitution>{});
    const auto rows = builder.CreateVectorOfStructs(updates);
    const auto normals = builder.CreateVectorOfStructs(std::vector<stored::Vec3>(3));
    const stored::Vec3 sky;
    const stored::SeaParameters sea;
    stored::FinishFramePacketBuffer(builder, stored::CreateFramePacket(builder, 0, 0, 0, channels, suns,
                                                                       lighting, objects, substitutions, rows,
                                                                       normals, 0, 0, &sky, 0, &sea));
    return decode_packet({builder.GetBufferPointer(), builder.GetSize()});
}

TEST(PacketBytes, CountsOfNormalsMustAddUp) {
    const char* const refusal = "damaged: its tables are not aligned, or its normals do not add up";
    const PacketResult sound = with_counts({1, 0, 2});
    ASSERT_TRUE(sound.packet) << sound.error;
    EXPECT_EQ(sound.packet->normal_updates[2].normals.size(), 2U);
    EXPECT_EQ(with_counts({1, 1}).error, refusal);
    EXPECT_EQ(with_counts({4}).error, refusal);
    EXPECT_EQ(with_counts({2, 0xffffffffU, 2}).error, refusal); // whose sum is 3 in 32 bits
}

} // namespace

} // namespace linkdig
