// Levels of detail: ranges, hysteresis, blends without gap or pop, and the history that makes a replay repeat.

#include "ig/active/detail_levels.h"

#include "host/packet/recording.h"
#include "ig/machine/history_bytes.h"
#include "ig/machine/machine.h"
#include "tests/database/compiler/authored.h"
#include "tests/ig/small_database.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace linkdig::ig {
namespace {

using database::CompileResult;

VisualDatabase three_levels(float hysteresis_m, float blend_m, bool added = false) {
    VisualDatabase database;
    database.details.push_back({.name = "d",
                                .hysteresis_m = hysteresis_m,
                                .blend_m = blend_m,
                                .added = static_cast<std::uint8_t>(added ? 1 : 0),
                                .levels = 3});
    database.detail_levels = {{0, 100}, {0, 300}, {0, 1000}};
    return database;
}

TEST(DetailLevels, ARangeHasOneLevel) {
    const VisualDatabase database = three_levels(0, 0);
    const Detail& detail = database.details[0];
    for (const std::uint32_t held : {0U, 1U, 2U, 3U, ~0U}) {
        EXPECT_EQ(level_at(database, detail, 0, held), 0U);
        EXPECT_EQ(level_at(database, detail, 100, held), 0U);
        EXPECT_EQ(level_at(database, detail, 100.001, held), 1U);
        EXPECT_EQ(level_at(database, detail, 999, held), 2U);
        EXPECT_EQ(level_at(database, detail, 1001, held), 3U); // nothing
    }
}

TEST(DetailLevels, HysteresisHoldsOnInBothDirections) {
    const VisualDatabase database = three_levels(20, 0);
    const Detail& detail = database.details[0];
    std::uint32_t held = ~0U;
    double out = 0, back = 0;
    for (double range = 50; range < 150; range += 0.25)
        if (const std::uint32_t now = level_at(database, detail, range, held); now != held) {
            held = now;
            out = range;
        }
    for (double range = 150; range > 50; range -= 0.25)
        if (const std::uint32_t now = level_at(database, detail, range, held); now != held) {
            held = now;
            back = range;
        }
    EXPECT_NEAR(out, 110, 0.3);
    EXPECT_NEAR(back, 90, 0.3);
    EXPECT_EQ(level_at(database, detail, 2000, 0), 3U); // a jump passes all ends at once
    EXPECT_EQ(level_at(database, detail, 995, 3), 3U);  // nothing is held, too
    EXPECT_EQ(level_at(database, detail, 989, 3), 2U);
    EXPECT_EQ(level_at(database, detail, 105, ~0U), 1U); // nothing held: ranges alone
}

TEST(DetailLevels, WhileTwoBlendOneOfThemIsWhole) {
    const VisualDatabase database = three_levels(0, 50);
    const Detail& detail = database.details[0];
    int before[3] = {256, 0, 0};
    for (double range = 0; range < 960; range += 0.25) {
        int now[3], whole = 0, present = 0;
        for (std::uint32_t k = 0; k < 3; ++k) {
            now[k] = blended_opacity(database, detail, range, k);
            EXPECT_LE(std::abs(now[k] - before[k]), 3) << range << " level " << k; // 256 over 25 m
            whole += now[k] == 256 ? 1 : 0;
            present += now[k] > 0 ? 1 : 0;
            before[k] = now[k];
        }
        EXPECT_GE(whole, 1) << range;
        EXPECT_LE(present, 2) << range;
    }
    EXPECT_EQ(blended_opacity(database, detail, 1012.5, 2), 128); // the last fades into nothing
    EXPECT_EQ(blended_opacity(database, detail, 1025, 2), 0);
}

TEST(DetailLevels, AddedLevelsReachFromTheEye) {
    const VisualDatabase database = three_levels(0, 50, true);
    EXPECT_EQ(blended_opacity(database, database.details[0], 10, 2), 256);
    EXPECT_EQ(blended_opacity(database, database.details[0], 10, 0), 256);
    EXPECT_EQ(blended_opacity(database, database.details[0], 112.5, 0), 128);
}

// ---- pictures ----------------------------------------------------------------------------------------------------------

constexpr const char* world = R"(
[database]
name = "t"
[[colour]]
name = "red"
rgb = [200, 40, 40]
[[colour]]
name = "green"
rgb = [40, 200, 40]
[[colour]]
name = "blue"
rgb = [40, 40, 200]
[[sun]]
name = "sun"
[[cluster]]
name = "cluster"
priority = 1
[[object_list]]
name = "list"
cluster = "cluster"
sun = "sun"
)";

std::string box_of(const std::string& name, const std::string& colour, int level, double half, double height,
                   const std::string& more = "list = \"list\"\n") {
    return fmt::format(
        "[[object]]\nname = \"{}\"\ncolour = \"{}\"\nshading = \"none\"\ndetail = \"d\"\nlevel = {}\n{}"
        "[[object.box]]\nfrom_m = [{}, {}, {}]\nto_m = [{}, {}, {}]\n",
        name, colour, level, more, -half, -half, -height, half, half, height);
}

std::string detail_of(const std::string& more) {
    return "[[detail]]\nname = \"d\"\ncluster = \"cluster\"\nreference_m = [0, 0, 0]\n" + more;
}

VisualDatabase compiled(const std::string& text) {
    const CompileResult result = database::compile_text(text);
    EXPECT_TRUE(result.database) << database::messages(result);
    return result.database.value_or(VisualDatabase{});
}

Configuration small(bool smoothing, std::uint32_t threads = 1) {
    Configuration configuration;
    configuration.raster = {64, 64, Scan::horizontal};
    configuration.edge_smoothing = smoothing;
    configuration.threads = threads;
    return configuration;
}

/// An eye `range_m` before the origin, looking at it through a long lens.
FramePacket packet_at(double range_m, std::uint64_t frame = 0) {
    FramePacket packet;
    packet.frame = frame;
    packet.channels = {channel_at({-range_m, 0, 0})};
    ChannelView& view = packet.channels[0];
    view.left_tangent = view.bottom_tangent = -20.0 / range_m;
    view.right_tangent = view.top_tangent = 20.0 / range_m;
    packet.suns = {{0, 0, 1}};
    packet.sky = {1, 0, 1};
    return packet;
}

int greatest_change(const std::vector<std::uint32_t>& a, const std::vector<std::uint32_t>& b) {
    int greatest = 0;
    for (std::size_t k = 0; k < a.size(); ++k)
        for (unsigned shift = 0; shift < 24; shift += 8)
            greatest = std::max(greatest, std::abs(static_cast<int>(a[k] >> shift & 255U) -
                                                   static_cast<int>(b[k] >> shift & 255U)));
    return greatest;
}

/// The bias moves the ranges under an eye that stands still: what changes is the blend and nothing else.
TEST(DetailLevels, ABlendHasNoPopAndNoGap) {
    const std::string text = world + detail_of("to_m = [200, 400]\nblend_m = 40\n") +
                             box_of("fine", "red", 0, 5, 9) +
                             box_of("coarse", "blue", 1, 9, 5); // each sticks out of the other
    for (const bool smoothing : {false, true}) {
        const VisualDatabase database = compiled(text);
        Machine machine(database, small(smoothing));
        std::vector<std::uint32_t> before, first;
        int greatest = 0;
        for (int step = 0; step <= 400; ++step) {
            FramePacket packet = packet_at(200, static_cast<std::uint64_t>(step));
            packet.lod_bias = static_cast<float>(0.2 - 0.001 * step); // ranges 174 to 230 m
            ASSERT_TRUE(machine.frame(packet).errors.empty());
            const std::vector<std::uint32_t> now = machine.picture(0).pixels;
            if (step == 0) first = now;
            if (step > 0) greatest = std::max(greatest, greatest_change(before, now));
            EXPECT_NE(now[32 * 64 + 32], 0xffff00ffU); // the sky never shines through the middle
            before = now;
        }
        EXPECT_GE(greatest_change(first, before), 160); // red has turned into blue
        EXPECT_LE(greatest, 4);                         // of 255 levels, in steps of a hundredth of the blend
    }
}

TEST(DetailLevels, ASlidingEyeSeesNoPop) {
    const VisualDatabase database =
        compiled(world + detail_of("to_m = [200, 400]\nblend_m = 40\n") + box_of("fine", "red", 0, 40, 40) +
                 box_of("coarse", "blue", 1, 40.5, 40.5));
    Machine machine(database, small(true));
    std::vector<std::uint32_t> before;
    int greatest = 0;
    for (double range = 170; range < 230;
         range += 0.1) { // the boxes fill the picture: only the blend changes it
        machine.frame(packet_at(range));
        if (!before.empty())
            greatest = std::max(greatest, greatest_change(before, machine.picture(0).pixels));
        before = machine.picture(0).pixels;
    }
    EXPECT_LE(greatest, 3);
    EXPECT_EQ(before[32 * 64 + 32], 0xffc82828U); // blue, all of it (bytes: 40, 40, 200)
}

/// A level fades as a whole: its faces do not show what they hide of their own level.
TEST(DetailLevels, AFadingLevelHidesItsOwnInside) {
    const VisualDatabase database =
        compiled(world + detail_of("to_m = [200, 400]\nblend_m = 40\n") + box_of("skin", "red", 0, 9, 9) +
                 box_of("inside", "green", 0, 5, 5) + box_of("coarse", "blue", 1, 9.5, 9.5));
    for (const bool smoothing : {false, true}) {
        Machine machine(database, small(smoothing));
        machine.frame(packet_at(210)); // half of the second half: the fine level is seen by one half
        const std::uint32_t middle = machine.picture(0).pixels[32 * 64 + 32];
        EXPECT_NEAR(middle & 255U, 120, 1);
        EXPECT_NEAR(middle >> 8U & 255U, 40, 1); // no green
        EXPECT_NEAR(middle >> 16U & 255U, 120, 1);
    }
}

TEST(DetailLevels, AllChannelsOfACabShowOneLevel) {
    const VisualDatabase database =
        compiled(world + detail_of("to_m = [200, 400]\n") + box_of("fine", "red", 0, 9, 9) +
                 box_of("coarse", "blue", 1, 9, 9));
    Machine machine(database, small(false));
    FramePacket packet = packet_at(205);
    packet.channels.push_back(packet_at(195).channels[0]);
    machine.frame(packet);
    EXPECT_EQ(machine.picture(0).pixels[32 * 64 + 32], machine.picture(1).pixels[32 * 64 + 32]);
    EXPECT_EQ(machine.picture(0).pixels[32 * 64 + 32] & 255U, 200U); // the nearest eye decides: red
    packet.channels[1].on = false;
    machine.frame(packet);
    EXPECT_EQ(machine.picture(0).pixels[32 * 64 + 32] & 255U, 40U);
}

TEST(DetailLevels, BiasDoublesAndHalvesTheRanges) {
    const VisualDatabase database =
        compiled(world + detail_of("to_m = [200, 400]\n") + box_of("fine", "red", 0, 9, 9) +
                 box_of("coarse", "blue", 1, 9, 9));
    Machine machine(database, small(false));
    const auto red_at = [&](double range, float bias) {
        FramePacket packet = packet_at(range);
        packet.lod_bias = bias;
        machine.frame(packet);
        return (machine.picture(0).pixels[32 * 64 + 32] & 255U) == 200U;
    };
    EXPECT_TRUE(red_at(200, 0));
    EXPECT_FALSE(red_at(200.001, 0));
    EXPECT_TRUE(red_at(399.99, 1));
    EXPECT_FALSE(red_at(400.01, 1));
    EXPECT_TRUE(red_at(99.99, -1));
    EXPECT_FALSE(red_at(100.01, -1));
}

/// The report's 3.2.3: a finer level in an additive list brightens the coarser one instead of replacing it.
TEST(DetailLevels, AnAdditiveListAndItsPartnerCanBeTwoLevels) {
    const std::string text =
        world +
        std::string("[[object_list]]\nname = \"glint\"\ncluster = \"cluster\"\nsun = \"sun\"\n"
                    "priority = -1\nadded_to = \"list\"\n") +
        detail_of("to_m = [200, 400]\nadded = true\nblend_m = 40\n") + box_of("sea", "blue", 1, 9, 9) +
        box_of("glint", "green", 0, 8, 8, "list = \"glint\"\n");
    for (const bool smoothing : {false, true}) {
        const VisualDatabase database = compiled(text);
        Machine machine(database, small(smoothing));
        const auto green_at = [&](double range) {
            machine.frame(packet_at(range));
            return machine.picture(0).pixels[32 * 64 + 32] >> 8U & 255U;
        };
        EXPECT_EQ(green_at(100), 240U); // the sum
        EXPECT_NEAR(green_at(210), 140, 1);
        EXPECT_EQ(green_at(300), 40U); // the partner alone
        EXPECT_EQ(green_at(500), 0U);  // nothing but sky
    }
}

// ---- history -----------------------------------------------------------------------------------------------------------

VisualDatabase held_database() {
    return compiled(world + detail_of("to_m = [200, 400]\nhysteresis_m = 60\n") +
                    box_of("fine", "red", 0, 9, 9) + box_of("coarse", "blue", 1, 9, 9));
}

/// Out through the hysteresis, back and out again.
FramePacket held_packet(int frame) {
    const int phase = frame % 80;
    return packet_at(phase < 40 ? 165 + 2 * phase : 245 - 2 * (phase - 40),
                     static_cast<std::uint64_t>(frame));
}

TEST(DetailHistory, AReplayFromAnyFrameGivesTheSameBytes) {
    const VisualDatabase database = held_database();
    Machine machine(database, small(true));
    std::vector<History> histories;
    std::vector<std::vector<std::uint32_t>> pictures;
    int mattered = 0;
    for (int frame = 0; frame < 120; ++frame) {
        histories.push_back(machine.history());
        machine.frame(held_packet(frame));
        pictures.push_back(machine.picture(0).pixels);
    }
    for (int from = 0; from < 120; from += 7) {
        Machine again(database, small(true, 3));
        Machine without(database, small(true));
        again.restore(*decode_history(encode_history(histories[static_cast<std::size_t>(from)])));
        for (int frame = from; frame < std::min(from + 12, 120); ++frame) {
            again.frame(held_packet(frame));
            without.frame(held_packet(frame));
            ASSERT_EQ(again.picture(0).pixels, pictures[static_cast<std::size_t>(frame)])
                << from << " " << frame;
            mattered += without.picture(0).pixels != pictures[static_cast<std::size_t>(frame)] ? 1 : 0;
        }
    }
    EXPECT_GT(mattered, 0); // without its history a replay differs
}

TEST(DetailHistory, ADiscontinuityForgets) {
    const VisualDatabase database = held_database();
    Machine machine(database, small(false));
    machine.frame(packet_at(100));
    machine.frame(packet_at(220)); // held by the hysteresis
    EXPECT_EQ(machine.history().held_level, std::vector<std::uint32_t>{0});
    FramePacket packet = packet_at(220);
    packet.discontinuity = true;
    machine.frame(packet);
    EXPECT_EQ(machine.history().held_level, std::vector<std::uint32_t>{1});
}

TEST(DetailHistory, ARefusedPacketLeavesItAlone) {
    const VisualDatabase database = held_database();
    Machine machine(database, small(false));
    machine.frame(packet_at(100));
    FramePacket packet = packet_at(390);
    packet.lod_bias = 17;
    EXPECT_FALSE(machine.frame(packet).errors.empty());
    EXPECT_EQ(machine.history().held_level, std::vector<std::uint32_t>{0});
}

TEST(DetailHistory, TravelsAsARecordingsFirstRecord) {
    const VisualDatabase database = held_database();
    const database::ScratchFolder folder;
    const std::string path = folder.path() + "/flight.rec";
    Machine machine(database, small(true));
    machine.frame(packet_at(100));
    std::vector<std::vector<std::uint32_t>> pictures;
    {
        RecordingWriter writer(path, {.update_rate_hz = 30.0}, encode_history(machine.history()));
        for (const double range : {220.0, 225.0, 235.0, 215.0}) {
            writer.write(packet_at(range));
            machine.frame(packet_at(range));
            pictures.push_back(machine.picture(0).pixels);
        }
        writer.close();
    }
    RecordingReader reader(path);
    Machine again(database, small(true));
    again.restore(*decode_history(reader.history()));
    FramePacket packet;
    for (const auto& picture : pictures) {
        ASSERT_TRUE(reader.next(packet));
        again.frame(packet);
        EXPECT_EQ(again.picture(0).pixels, picture);
    }
}

TEST(DetailHistory, BytesThatAreNoHistoryAreRefused) {
    const std::vector<std::uint8_t> bytes = encode_history({.held_level = {0, 3, 7}});
    EXPECT_EQ(decode_history(bytes)->held_level, (std::vector<std::uint32_t>{0, 3, 7}));
    EXPECT_EQ(*decode_history({}), History{});
    for (std::size_t length = 1; length < bytes.size(); ++length)
        EXPECT_FALSE(decode_history(std::span(bytes).first(length))) << length;
    std::vector<std::uint8_t> longer = bytes;
    longer.push_back(0);
    EXPECT_FALSE(decode_history(longer));
    std::vector<std::uint8_t> other = bytes;
    other[0] = 99;
    EXPECT_FALSE(decode_history(other));
    std::vector<std::uint8_t> many = bytes;
    many[7] = 0xff; // details beyond all memory
    EXPECT_FALSE(decode_history(many));
}

} // namespace
} // namespace linkdig::ig
