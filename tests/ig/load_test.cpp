// Overload: the frame is completed, the next ones are drawn with less, and the report says so.

#include "ig/machine/load.h"

#include "database/model/random.h"
#include "ig/active/shedding.h"
#include "ig/machine/history_bytes.h"
#include "ig/machine/machine.h"
#include "tests/database/compiler/authored.h"
#include "tests/ig/small_database.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace linkdig::ig {
namespace {

using testing::ElementsAre;

std::string box_at(const std::string& name, const std::string& more, double x, double y, double z,
                   double half) {
    return fmt::format("[[object]]\nname = \"{}\"\nlist = \"list\"\ncolour = \"grey\"\n{}[[object.box]]\n"
                       "from_m = [{:.3f}, {:.3f}, {:.3f}]\nto_m = [{:.3f}, {:.3f}, {:.3f}]\n",
                       name, more, x - half, y - half, z - half, x + half, y + half, z + half);
}

/// A wall of boxes 100 m ahead: three clusters of detail, of 49 boxes near and one far, and 100 boxes of all sizes.
VisualDatabase town() {
    std::string text = "[[detail]]\nname = \"d\"\ncluster = \"cluster\"\nreference_m = [100, 0, 0]\n"
                       "to_m = [200, 600]\nhysteresis_m = 4\n";
    for (int k = 0; k < 49; ++k)
        text += box_at(fmt::format("near {}", k), "detail = \"d\"\nlevel = 0\n", 100, 4 * (k % 7) - 12,
                       4 * (k / 7) - 12, 1);
    text += box_at("far", "detail = \"d\"\nlevel = 1\n", 100, 0, 0, 12);
    for (std::uint64_t k = 0; k < 100; ++k) {
        const auto row = static_cast<double>(k / 10), column = static_cast<double>(k % 10);
        text += box_at(fmt::format("small {}", k), "", 120, 6 * column - 27, 6 * row - 27,
                       0.05 + 2.0 * random_unit(3, k));
    }
    const database::CompileResult result = database::compile_text(database::scene(text));
    EXPECT_TRUE(result.database) << database::messages(result);
    return result.database.value_or(VisualDatabase{});
}

Configuration limited(Capacity capacity, std::uint32_t threads = 1, bool smoothing = false) {
    Configuration configuration;
    configuration.raster = {256, 256, Scan::horizontal};
    configuration.capacity = capacity;
    configuration.threads = threads;
    configuration.edge_smoothing = smoothing;
    return configuration;
}

FramePacket packet_at(double x, std::uint64_t frame = 0) {
    FramePacket packet;
    packet.frame = frame;
    packet.channels = {channel_at({x, 0, 0})};
    packet.suns = {{0, 0, 1}};
    return packet;
}

ChannelReport counts_of(const VisualDatabase& database, const FramePacket& packet) {
    Machine machine(database, limited({}));
    return machine.frame(packet).channels[0];
}

TEST(Load, AMachineWithoutLimitsOrBelowThemDrawsTheSame) {
    const VisualDatabase database = town();
    const std::uint64_t edges = counts_of(database, packet_at(0)).edges;
    Machine free(database, limited({}));
    Machine enough(database, limited({.edges = edges}));
    for (int frame = 0; frame < 3; ++frame) {
        EXPECT_FALSE(free.frame(packet_at(0)).overload.any());
        EXPECT_FALSE(enough.frame(packet_at(0)).overload.any());
        EXPECT_EQ(free.picture(0).pixels, enough.picture(0).pixels);
    }
    EXPECT_EQ(enough.history().load, LoadState{});
}

/// Below the limit within two frames, and then at rest for all of ten seconds.
void expect_settles(const VisualDatabase& database, Capacity capacity, bool smoothing) {
    Machine machine(database, limited(capacity, 1, smoothing));
    std::uint32_t last_step = 0, changes = 0;
    for (int frame = 0; frame < 300; ++frame) {
        const FrameReport& report = machine.frame(packet_at(0, static_cast<std::uint64_t>(frame)));
        ASSERT_TRUE(report.errors.empty());
        const bool over = report.overload.edges_over != 0 || report.overload.crossings_over != 0;
        EXPECT_EQ(over, (capacity.edges != 0 && report.channels[0].edges > capacity.edges) ||
                            (capacity.crossings_on_a_line != 0 &&
                             report.channels[0].most_crossings_on_a_line > capacity.crossings_on_a_line));
        EXPECT_TRUE(frame != 0 || over);
        EXPECT_TRUE(frame < 2 || !over) << "frame " << frame;
        EXPECT_TRUE(frame == 0 || report.overload.step > 0); // what is left out is said
        if (frame > 2 && report.overload.step != last_step) {
            EXPECT_LT(report.overload.step, last_step); // back only, and only so far as is sure to be borne
            ++changes;
        }
        EXPECT_TRUE(frame <= 200 || report.overload.step == last_step);
        last_step = report.overload.step;
    }
    EXPECT_LE(changes, most_steps);
}

TEST(Load, ASceneOverItsLimitSettlesWithinTwoFramesAndStays) {
    const VisualDatabase database = town();
    const ChannelReport whole = counts_of(database, packet_at(0));
    for (const bool smoothing : {false, true})
        for (const std::uint64_t percent : {95U, 80U, 60U, 40U, 25U, 10U}) {
            SCOPED_TRACE(percent);
            expect_settles(database, {.edges = whole.edges * percent / 100}, smoothing);
        }
    for (const std::uint64_t percent : {90U, 60U, 30U}) {
        SCOPED_TRACE(percent);
        expect_settles(database, {.crossings_on_a_line = whole.most_crossings_on_a_line * percent / 100},
                       false);
    }
}

TEST(Load, DetailGoesInTheWrittenOrder) {
    const VisualDatabase database = town();
    const std::uint64_t edges = counts_of(database, packet_at(0)).edges;
    Machine machine(database, limited({.edges = edges * 9 / 10}));
    machine.frame(packet_at(0));
    Overload overload = machine.frame(packet_at(0)).overload;
    EXPECT_LE(overload.step, level_steps); // the coarser level alone is enough
    EXPECT_EQ(overload.coarser_details, 1U);
    EXPECT_LT(overload.range_factor, 0.5001);
    EXPECT_EQ(overload.objects_left_out, 0U);
    Machine tight(database, limited({.edges = edges / 5}));
    tight.frame(packet_at(0));
    overload = tight.frame(packet_at(0)).overload;
    EXPECT_GT(overload.step, level_steps);
    EXPECT_EQ(overload.coarser_details, 1U);
    EXPECT_GT(overload.objects_left_out, 10U);
    EXPECT_GT(overload.least_size_px, 0.0);
    for (std::uint32_t step = 1; step <= most_steps; ++step) {
        EXPECT_LE(bias_at_step(step), bias_at_step(step - 1));
        EXPECT_GE(least_size_px(step), least_size_px(step - 1));
    }
}

TEST(Load, AMovingEyeIsBackWithinTwoFramesEachTime) {
    const VisualDatabase database = town();
    const std::uint64_t limit = counts_of(database, packet_at(0)).edges / 2;
    Machine machine(database, limited({.edges = limit}));
    int over_for = 0, times = 0;
    for (int frame = 0; frame < 300; ++frame) {
        const double x = frame < 150 ? -300 + 2.0 * frame : 2.0 * (150 - frame);
        over_for = machine.frame(packet_at(x)).overload.edges_over != 0 ? over_for + 1 : 0;
        times += over_for == 1 ? 1 : 0;
        EXPECT_LE(over_for, 2) << frame;
    }
    EXPECT_GE(times, 1);
    EXPECT_LE(times, 6);
    EXPECT_GE(machine.history().load.step, 0U);
}

TEST(Load, DetailComesBackWhenItCanBeBorne) {
    const VisualDatabase database = town();
    Machine machine(database, limited({.edges = counts_of(database, packet_at(0)).edges / 2}));
    for (int frame = 0; frame < 5; ++frame)
        machine.frame(packet_at(0));
    EXPECT_GT(machine.history().load.step, 0U);
    for (std::uint32_t frame = 0; frame < calm_frames * most_steps;
         ++frame) { // looks the other way: nothing to draw
        FramePacket packet = packet_at(0);
        packet.channels[0].attitude.heading_rad = 3.0;
        machine.frame(packet);
    }
    EXPECT_EQ(machine.history().load, LoadState{});
}

TEST(Load, WhatCannotBeShedIsDrawnAndSaid) {
    const database::CompileResult result =
        database::compile_text(database::scene(box_at("house", "", 20, 0, 0, 8)));
    ASSERT_TRUE(result.database);
    Machine machine(*result.database, limited({.edges = 1}));
    Machine free(*result.database, limited({}));
    for (int frame = 0; frame < 40; ++frame) {
        EXPECT_GT(machine.frame(packet_at(0)).overload.edges_over, 0U);
        free.frame(packet_at(0));
        EXPECT_EQ(machine.picture(0).pixels, free.picture(0).pixels);
    }
}

TEST(Load, AllChannelsLeaveOutTheSame) {
    const VisualDatabase database = town();
    FramePacket packet = packet_at(0);
    packet.channels.push_back(packet.channels[0]);
    Machine machine(database, limited({.edges = counts_of(database, packet_at(0)).edges}));
    machine.frame(packet); // twice the limit
    const FrameReport& report = machine.frame(packet);
    EXPECT_EQ(report.overload.edges_over, 0U);
    EXPECT_EQ(report.channels[0].edges, report.channels[1].edges);
    EXPECT_EQ(machine.picture(0).pixels, machine.picture(1).pixels);
}

TEST(Load, IsPartOfTheHistoryAndBlindToThreads) {
    const VisualDatabase database = town();
    const Capacity capacity{.edges = counts_of(database, packet_at(0)).edges / 2};
    Machine one(database, limited(capacity, 1, true));
    Machine three(database, limited(capacity, 3, true));
    History at_20;
    std::vector<std::vector<std::uint32_t>> pictures;
    for (int frame = 0; frame < 40; ++frame) {
        const FramePacket packet = packet_at(-60 + 2.0 * frame);
        if (frame == 20) at_20 = one.history();
        one.frame(packet);
        three.frame(packet);
        ASSERT_EQ(one.picture(0).pixels, three.picture(0).pixels) << frame;
        ASSERT_EQ(one.history(), three.history());
        pictures.push_back(one.picture(0).pixels);
    }
    Machine again(database, limited(capacity, 1, true));
    ASSERT_GT(at_20.load.step, 0U);
    again.restore(*decode_history(encode_history(at_20)));
    for (int frame = 20; frame < 40; ++frame) {
        again.frame(packet_at(-60 + 2.0 * frame));
        ASSERT_EQ(again.picture(0).pixels, pictures[static_cast<std::size_t>(frame)]) << frame;
    }
}

TEST(Load, CrossingsAreThoseOfTheBusiestLine) {
    FaceEdges edges;
    edges.edges = {{.first_line = 0, .end_line = 10},
                   {.first_line = 5, .end_line = 6},
                   {.first_line = 6, .end_line = 10}};
    std::vector<std::int64_t> on_line;
    EXPECT_EQ(most_crossings(edges, 10, on_line), 2U);
    EXPECT_EQ(most_crossings({}, 10, on_line), 0U);
}

TEST(Load, IsToldInWords) {
    EXPECT_TRUE(overload_text({}).empty());
    EXPECT_THAT(overload_text({.step = 10,
                               .range_factor = 0.0625,
                               .coarser_details = 3,
                               .least_size_px = 2,
                               .objects_left_out = 41,
                               .edges_over = 7,
                               .crossings_over = 2}),
                ElementsAre("7 edges beyond the limit; the frame is complete",
                            "2 crossings beyond the limit on the busiest line; the frame is complete",
                            "levels of detail end at 0.06 of their range: 3 show less",
                            "objects under 2 px left out: 41"));
}

} // namespace
} // namespace linkdig::ig
