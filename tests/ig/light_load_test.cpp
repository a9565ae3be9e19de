// Light points beyond the machine's limit: strings grow thin, the frame is completed, the report says so.

#include "ig/active/light_steps.h"
#include "ig/machine/history_bytes.h"
#include "ig/machine/load.h"
#include "ig/machine/machine.h"
#include "tests/database/compiler/authored.h"
#include "tests/ig/small_database.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace linkdig::ig {
namespace {

using testing::ElementsAre;

/// Two strings of lights across the view, 100 m ahead; every odd one of the second stands behind the eye.
VisualDatabase strings() {
    std::string text = "[[object]]\nname = \"strings\"\nlist = \"list\"\ncolour = \"grey\"\n"
                       "[[object.light_string]]\nfrom_m = [100, -40, 5]\nto_m = [100, 40, 5]\ncount = 301\n";
    for (int k = 0; k < 100; ++k)
        text += fmt::format("[[object.light]]\nposition_m = [{}, {:.1f}, -5]\n", k % 2 == 0 ? 100 : -100,
                            -40 + 0.8 * k);
    const database::CompileResult result = database::compile_text(database::scene(text));
    EXPECT_TRUE(result.database) << database::messages(result);
    return result.database.value_or(VisualDatabase{});
}

Configuration limited_to(std::uint64_t light_points, std::uint32_t threads = 1) {
    Configuration configuration;
    configuration.raster = {256, 256, Scan::horizontal};
    configuration.capacity.light_points = light_points;
    configuration.threads = threads;
    return configuration;
}

FramePacket packet_of(bool away = false) {
    FramePacket packet;
    packet.channels = {channel_at({0, 0, 0})};
    packet.channels[0].attitude.heading_rad = away ? 3.0 : 0.0;
    packet.suns = {{0, 0, 1}};
    return packet;
}

std::uint64_t all_lights(const VisualDatabase& database) {
    Machine machine(database, limited_to(0));
    return machine.frame(packet_of()).channels[0].lights;
}

TEST(LightLoad, AMachineWithoutALimitOrBelowItDrawsTheSame) {
    const VisualDatabase database = strings();
    Machine free(database, limited_to(0));
    Machine enough(database, limited_to(all_lights(database)));
    EXPECT_GT(all_lights(database), 300U);
    for (int frame = 0; frame < 3; ++frame) {
        EXPECT_FALSE(free.frame(packet_of()).overload.any());
        EXPECT_FALSE(enough.frame(packet_of()).overload.any());
        EXPECT_EQ(free.picture(0).pixels, enough.picture(0).pixels);
    }
    EXPECT_EQ(enough.history().load, LoadState{});
}

TEST(LightLoad, TheFirstFrameIsWholeAndTheSecondWithinTheLimitForGood) {
    const VisualDatabase database = strings();
    const std::uint64_t whole = all_lights(database);
    for (const std::uint64_t percent : {99U, 90U, 60U, 50U, 45U, 20U, 5U}) {
        SCOPED_TRACE(percent);
        const std::uint64_t limit = whole * percent / 100;
        Machine machine(database, limited_to(limit));
        const FrameReport& report = machine.frame(packet_of());
        EXPECT_EQ(report.channels[0].lights, whole);
        EXPECT_EQ(report.overload.lights_over, whole - limit);
        EXPECT_EQ(report.overload.lights_left_out, 0U);
        machine.frame(packet_of());
        const std::uint32_t step = report.overload.light_step;
        EXPECT_GT(step, 0U);
        for (int frame = 2; frame < 300; ++frame) {
            ASSERT_LE(report.channels[0].lights, limit);
            ASSERT_GT(report.channels[0].lights, 0U);
            ASSERT_EQ(report.overload.lights_over, 0U);
            ASSERT_EQ(report.overload.light_step,
                      step); // a scene that stands still does not go back and forth
            ASSERT_EQ(report.overload.lights_left_out, 401U - ((401U + (1U << step) - 1U) >> step));
            machine.frame(packet_of());
        }
    }
}

TEST(LightLoad, LightsComeBackWhenTheyCanBeBorne) {
    const VisualDatabase database = strings();
    const std::uint64_t whole = all_lights(database);
    Machine machine(database, limited_to(whole / 10));
    machine.frame(packet_of());
    machine.frame(packet_of());
    EXPECT_GE(machine.history().load.light_step, 3U);
    for (std::uint32_t frame = 0; frame < calm_frames * light_steps; ++frame)
        machine.frame(packet_of(true)); // half of the second string is there
    EXPECT_LT(machine.history().load.light_step, 3U);
    EXPECT_LE(machine.frame(packet_of(true)).channels[0].lights, whole / 10);
}

TEST(LightLoad, ALimitThatNoStepReachesIsSaid) {
    const VisualDatabase database = strings();
    Machine machine(database, limited_to(1));
    for (int frame = 0; frame < 40; ++frame)
        machine.frame(packet_of());
    const FrameReport& report = machine.frame(packet_of());
    EXPECT_EQ(report.overload.light_step, light_steps);
    EXPECT_EQ(report.channels[0].lights, 2U); // numbers 0 and 256
    EXPECT_EQ(report.overload.lights_over, 1U);
}

TEST(LightLoad, IsPartOfTheHistoryAndBlindToThreads) {
    const VisualDatabase database = strings();
    Machine one(database, limited_to(100));
    Machine three(database, limited_to(100, 3));
    for (int frame = 0; frame < 50; ++frame) {
        one.frame(packet_of(frame % 20 > 10));
        three.frame(packet_of(frame % 20 > 10));
        ASSERT_EQ(one.picture(0).pixels, three.picture(0).pixels) << frame;
        ASSERT_EQ(one.history(), three.history());
        ASSERT_EQ(decode_history(encode_history(one.history())), one.history());
    }
}

TEST(LightLoad, AHistoryFromBeforeThereWereLightStepsIsRead) {
    const std::vector<std::uint8_t> written{1, 0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0,
                                            3, 0, 0, 0, 4, 0, 0, 0, 5, 0, 0, 0};
    const std::optional<History> history = decode_history(written);
    ASSERT_TRUE(history);
    EXPECT_EQ(history->held_level, std::vector<std::uint32_t>{2});
    EXPECT_EQ(history->load, (LoadState{.step = 3, .calm = 4, .over = 5}));
    std::vector<std::uint8_t> newer = written;
    newer[0] = 2;
    EXPECT_FALSE(decode_history(newer)); // ends too soon
    newer[0] = 3;
    EXPECT_FALSE(decode_history(newer));
}

TEST(LightLoad, IsToldInWords) {
    EXPECT_THAT(overload_text({.light_step = 3, .lights_left_out = 700, .lights_over = 5}),
                ElementsAre("5 light points beyond the limit; the frame is complete",
                            "light points: one of 8 is there: 700 left out"));
}

} // namespace
} // namespace linkdig::ig
