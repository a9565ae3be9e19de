#include "host/packet/packet_json.h"

#include "database/model/random.h"
#include "tests/host/packet/sample_packet.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

namespace linkdig {

namespace {

using testing::HasSubstr;
using testing::StartsWith;

TEST(PacketJson, GivesBackTheSameBits) {
    for (const FramePacket& packet : {sample_packet(), FramePacket{}}) {
        const std::string text = to_json(packet);
        EXPECT_EQ(text.find('\n'), std::string::npos);
        const PacketResult read = from_json(text);
        ASSERT_TRUE(read.packet) << read.error;
        EXPECT_EQ(difference(*read.packet, packet), "");
        EXPECT_EQ(to_json(*read.packet), text);
    }
}

TEST(PacketJson, GivesBackEveryNumber) {
    for (std::uint64_t i = 0; i < 20'000; ++i) {
        FramePacket packet;
        packet.time_s = std::bit_cast<double>(random_bits(1, i));
        packet.lod_bias = std::bit_cast<float>(static_cast<std::uint32_t>(random_bits(2, i)));
        if (std::isnan(packet.time_s) || std::isnan(packet.lod_bias))
            continue; // text does not keep which NaN
        const PacketResult read = from_json(to_json(packet));
        ASSERT_TRUE(read.packet) << read.error;
        EXPECT_EQ(difference(*read.packet, packet), "") << to_json(packet);
    }
}

TEST(PacketJson, GivesBackWhatIsNoNumber) {
    FramePacket packet;
    packet.time_s = std::numeric_limits<double>::quiet_NaN();
    packet.visibility_m = std::numeric_limits<float>::infinity();
    packet.sea.state = -std::numeric_limits<float>::infinity();
    const PacketResult read = from_json(to_json(packet));
    ASSERT_TRUE(read.packet) << read.error;
    EXPECT_TRUE(std::isnan(read.packet->time_s));
    EXPECT_EQ(read.packet->visibility_m, packet.visibility_m);
    EXPECT_EQ(read.packet->sea.state, packet.sea.state);
}

// A contract with hosts in other languages.
TEST(PacketJson, ReadsAsTheStructsDo) {
    FramePacket packet;
    packet.frame = 7;
    packet.database_id = 0x1f;
    packet.channels.push_back({.eye_m = {1.5, -2, 30}, .attitude = {}});
    packet.suns.emplace_back(0.6F, 0.0F, 0.8F);
    packet.lighting = {{.list = 3, .ambient = 0.3F}};
    packet.substitutions = {{.slot = 0, .index = 27}};
    EXPECT_EQ(
        to_json(packet),
        R"({"frame":7,"time_s":0.0,"database_id":"0x1f","channels":[{"on":true,"eye_m":[1.5,-2.0,30.0],)"
        R"("attitude":{"heading_rad":0.0,"pitch_rad":0.0,"roll_rad":0.0},"left_tangent":-0.577,"right_tangent":0.577,)"
        R"("bottom_tangent":-0.577,"top_tangent":0.577}],"suns":[[0.6,0.0,0.8]],"lighting":[{"list":3,"sun":0,)"
        R"("ambient":0.3,"diffuse":1.0,"colour":-1,"method":"as_modelled"}],"moving_objects":[],)"
        R"("substitutions":[{"slot":0,"index":27}],"normal_updates":[],"lod_bias":0.0,"visibility_m":0.0,)"
        R"("sky":[0.6,0.72,0.86],"time_of_day_h":12.0,"colours":[],"light_points":1.0,)"
        R"("sea":{"state":0.0,"current_east_mps":0.0,"current_north_mps":0.0},"seed":"0x0","discontinuity":false,"priorities":[],"host_values":[],"wakes":[],"quays":[]})");
}

TEST(PacketJson, TakesDefaultsForWhatIsLeftOut) {
    const PacketResult read =
        from_json(R"({"frame": 3, "channels": [{"eye_m": [1, 2, 3]}], "database_id": 31})");
    ASSERT_TRUE(read.packet) << read.error;
    FramePacket expected;
    expected.frame = 3;
    expected.database_id = 0x1f;
    expected.channels.push_back({.eye_m = {1, 2, 3}, .attitude = {}});
    EXPECT_EQ(difference(*read.packet, expected), "");
}

TEST(PacketJson, MistakesAreNamedByTheirField) {
    const auto expect_told = [](const char* text, const char* told) {
        const PacketResult read = from_json(text);
        EXPECT_FALSE(read.packet) << text;
        EXPECT_EQ(read.error, told);
    };
    expect_told("{}", "frame: missing");
    expect_told("[]", "expected an object");
    expect_told(R"({"frame": -1})", "frame: expected an integer from 0 to 18446744073709551615");
    expect_told(R"({"frame": 1.5})", "frame: expected an integer from 0 to 18446744073709551615");
    expect_told(R"({"frame": 1, "frame": 2})", "frame: stands twice in one object");
    expect_told(R"({"frame": 1, "time_s": null})", "time_s: expected a number");
    expect_told(R"({"frame": 1, "time_s": "1"})", "time_s: expected a number");
    expect_told(R"({"frame": 1, "lod_bias": 1e39})", "lod_bias: out of range for a 32-bit float");
    expect_told(R"({"frame": 1, "discontinuity": 1})", "discontinuity: expected true or false");
    expect_told(R"({"frame": 1, "seed": "17"})",
                "seed: expected \"0x\" and up to 16 hexadecimal digits, or an integer");
    expect_told(R"({"frame": 1, "seed": "0x"})",
                "seed: expected \"0x\" and up to 16 hexadecimal digits, or an integer");
    expect_told(R"({"frame": 1, "seed": "0x10000000000000000"})",
                "seed: expected \"0x\" and up to 16 hexadecimal digits, or an integer");
    expect_told(R"({"frame": 1, "seed": "0xfg"})",
                "seed: expected \"0x\" and up to 16 hexadecimal digits, or an integer");
    expect_told(R"({"frame": 1, "channels": {}})", "channels: expected an array");
    expect_told(R"({"frame": 1, "channels": [{}, {"eye_m": [1, 2]}]})",
                "channels[1].eye_m: expected an array of three numbers");
    expect_told(R"({"frame": 1, "channels": [{"eye_m": [1, 2, "x"]}]})",
                "channels[0].eye_m[2]: expected a number");
    expect_told(
        R"({"frame": 1, "channels": [{"attitude": {"heading": 1}}]})",
        "channels[0].attitude.heading: unknown field; expected one of heading_rad, pitch_rad, roll_rad");
    expect_told(R"({"frame": 1, "lighting": [{}]})", "lighting[0].list: missing");
    expect_told(R"({"frame": 1, "lighting": [{"list": 4294967296}]})",
                "lighting[0].list: expected an integer from 0 to 4294967295");
    expect_told(R"({"frame": 1, "lighting": [{"list": 0, "colour": -2}]})",
                "lighting[0].colour: expected an integer from 0 to 2147483647, or -1 for none");
    expect_told(R"({"frame": 1, "lighting": [{"list": 0, "method": "gouraud"}]})",
                "lighting[0].method: expected \"as_modelled\" or \"no_smooth\"");
    expect_told(R"({"frame": 1, "substitutions": [{"slot": 0}]})", "substitutions[0].index: missing");
    expect_told(R"({"frame": 1, "normal_updates": [{"list": 0}]})", "normal_updates[0].normals: missing");
}

TEST(PacketJson, SyntaxErrorsAreToldNotThrown) {
    for (const char* text :
         {"", "{", "nonsense", "{\"frame\": 1} x", "{\"frame\": 1e999}", "\xff", "{\"frame\": 01}"})
        EXPECT_THAT(from_json(text).error, StartsWith("not JSON: ")) << text;
    EXPECT_FALSE(from_json(std::string(100'000, '[')).packet); // nested deeply
    EXPECT_THAT(from_json("{\"frame\": 1,}").error, HasSubstr("column 13"));
}

} // namespace

} // namespace linkdig
