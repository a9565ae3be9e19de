#include "tools/fly/status.h"

#include <gmock/gmock.h>

namespace linkdig::tools {
namespace {

using host::Signal;
using testing::HasSubstr;

VisualDatabase one_sea() {
    VisualDatabase database;
    database.lists.resize(2);
    database.lists[1].sun = 1;
    database.tiles.push_back({.list = 1});
    return database;
}

FramePacket packet_with(float first_height, float second_height) {
    FramePacket packet;
    packet.frame = 123;
    packet.time_s = 2.05;
    packet.suns = {Vec3f(0, 0, first_height), Vec3f(0, 0, second_height)};
    return packet;
}

TEST(Status, TellsFrameTimeEdgesAndOverruns) {
    FrameReport report;
    report.channels = {{.edges = 1000}, {.edges = 234}};
    report.overruns = 7;
    const auto lines = status_lines(one_sea(), packet_with(0, 0), report, {});
    ASSERT_EQ(lines.size(), 2U);
    EXPECT_EQ(lines[0], "frame   123    2.05 s  edges   1234  overruns 7");
}

TEST(Status, TellsWhatEachStageTook) {
    const ig::StageTimes stages = {
        .active_s = 0.0001, .water_s = 0.0005, .geometry_s = 0.00125, .scanline_s = 0.012, .video_s = 1e-6};
    EXPECT_EQ(stage_line(stages),
              "active 0.10  water 0.50  priority 0.00  geometry 1.25  edges 0.00  lights 0.00  "
              "bands 0.00  scanline 12.00  video 0.00 ms");
}

TEST(Status, TheSunIsThatOfTheSeasList) {
    EXPECT_NEAR(sea_sun_elevation_deg(one_sea(), packet_with(1.0F, 0.5F)), 30.0, 1e-5);
    FramePacket overridden = packet_with(1.0F, 0.5F);
    overridden.lighting.push_back({.list = 1, .sun = 0});
    EXPECT_NEAR(sea_sun_elevation_deg(one_sea(), overridden), 90.0, 1e-5);
}

TEST(Status, NoSeaNoSun) {
    EXPECT_EQ(sea_sun_elevation_deg({}, packet_with(1, 1)), 0.0);
    EXPECT_EQ(sea_sun_elevation_deg(one_sea(), {}), 0.0);
}

TEST(Status, TellsWhatTheKeysHaveSet) {
    host::SignalValues signals;
    EXPECT_EQ(status_lines(one_sea(), packet_with(0, 0.5F), {}, signals)[1],
              "view ahead  12:00  sea's sun 30 deg, x 1.00  smooth shading on ");
    signals.set(Signal::view, 3);
    signals.set(Signal::smooth_shading, 0);
    signals.set(Signal::freeze, 1);
    signals.set(Signal::sea_sun_rate, 1.25);
    EXPECT_EQ(status_lines(one_sea(), packet_with(0, 0.5F), {}, signals)[1],
              "view down   12:00  sea's sun 30 deg, x 1.25  smooth shading off  paused");
}

} // namespace
} // namespace linkdig::tools
