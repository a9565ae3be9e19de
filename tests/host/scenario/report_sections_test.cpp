// What the report's methods need of a scenario: tracks, time histories, limits, methods, sea states, the own ship.

#include "host/scenario/bind.h"
#include "host/scenario/scenario.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace linkdig::host {
namespace {

using testing::HasSubstr;
using testing::SizeIs;

/// A folder of this process alone that goes when the process ends.
struct ScratchFolder {
    const std::string path = testing::TempDir() + "linkdig-sections-" + std::to_string(::getpid());
    ScratchFolder() { std::filesystem::create_directories(path); }
    ~ScratchFolder() { std::filesystem::remove_all(path); }
    std::string file(const char* name, const std::string& text) const {
        std::ofstream(path + "/" + name) << text;
        return path + "/" + name;
    }
};

const ScratchFolder& folder() {
    static const ScratchFolder made;
    return made;
}

/// `ship` is put into the [[ship]], `rest` stands at the end.
ScenarioResult loaded(const std::string& ship, const std::string& rest = "",
                      const std::string& sun = "elevation_deg = 30") {
    return load_scenario(folder().file("test.toml", R"([scenario]
name = "test"
database = "sea.toml"
duration_s = 20
[suns.ocean]
azimuth_deg = 90
)" + sun + R"(
[[channel]]
name = "ahead"
horizontal_field_deg = 60
[own_ship]
kind = "fixed"
position_m = [0, 0, 10]
aim_m = [100, 0, 0]
[[ship]]
moving_object = "lph2"
heading_deg = 20
speed_kt = 12
)" + ship + "\n" + rest));
}

std::string mistakes(const std::string& ship, const std::string& rest = "",
                     const std::string& sun = "elevation_deg = 30") {
    const ScenarioResult result = loaded(ship, rest, sun);
    EXPECT_FALSE(result.scenario.has_value());
    return result.diagnostics.text();
}

Scenario sound(const std::string& ship, const std::string& rest = "",
               const std::string& sun = "elevation_deg = 30") {
    const ScenarioResult result = loaded(ship, rest, sun);
    EXPECT_EQ(result.diagnostics.text(), "");
    return result.scenario.value_or(Scenario{});
}

TEST(ReportSections, TracksAreRead) {
    const Scenario scenario =
        sound("[ship.track]\nkind = \"turn\"\nradius_m = 500\nbegin_s = 3\nangle_deg = 90\nto = \"port\"",
              "[[ship]]\nmoving_object = \"dd963\"\n[ship.track]\nkind = \"station\"\nleader = "
              "\"lph2\"\noffset_m = [-400, 80, 0]");
    const TrackSection& turn = scenario.ships.at(0).track;
    EXPECT_EQ(turn.kind, TrackSection::Kind::turn);
    EXPECT_TRUE(turn.to_port);
    EXPECT_NEAR(degrees(turn.angle_rad), 90.0, 1e-9);
    EXPECT_EQ(scenario.ships.at(1).track.leader.text, "lph2");
    EXPECT_EQ(scenario.ships.at(1).track.offset_m, Vec3d(-400, 80, 0));
}

TEST(ReportSections, MistakesInTracksAreTold) {
    EXPECT_THAT(mistakes("[ship.track]\nkind = \"circle\""),
                HasSubstr("\"kind\" is \"circle\"; expected one of \"straight\", \"turn\", "
                          "\"figure_of_eight\", \"station\""));
    EXPECT_THAT(mistakes("[ship.track]\nkind = \"turn\""),
                HasSubstr("[ship.track] lacks the key \"radius_m\""));
    database::Diagnostics unbound;
    bind(sound("", "[[ship]]\nmoving_object = \"dd963\"\n[ship.track]\nkind = \"station\"\nleader "
                   "= \"lpd\"\noffset_m = [1, 2, 0]"),
         {}, unbound);
    EXPECT_THAT(unbound.text(), HasSubstr("no [[ship]] has the moving object \"lpd\""));
    EXPECT_THAT(mistakes("",
                         "[[ship]]\nmoving_object = \"dd963\"\n[ship.track]\nkind = \"station\"\nleader = "
                         "\"dd963\"\noffset_m = [1, 2, 0]"),
                HasSubstr("\"dd963\" keeps station herself"));
}

TEST(ReportSections, LimitsArePresetsThatKeysOverride) {
    const std::string motion = "[ship.motion]\nsignificant_height_m = 2\nperiod_s = 9\nseas_from_deg = 0\n";
    const auto limits = [&](const std::string& more) {
        const Scenario scenario = sound(motion + more);
        const auto& axes = scenario.ships.at(0).motion.value_or(MotionSection{}).axes;
        return std::pair(degrees(axes[3].limit), degrees(axes[4].limit));
    };
    EXPECT_NEAR(limits("limits = \"landing\"").first, 6.8, 1e-9);
    EXPECT_NEAR(limits("limits = \"landing\"").second, 5.0, 1e-9);
    EXPECT_NEAR(limits("limits = \"demonstration\"").second, 10.0, 1e-9);
    EXPECT_NEAR(limits("limits = \"demonstration\"\npitch_limit_deg = 7").second, 7.0, 1e-9);
    EXPECT_NEAR(limits("").first, 8.0, 1e-9);
}

TEST(ReportSections, ATimeHistoryMovesTheShip) {
    folder().file("motion.csv",
                  "# one comment\ntime_s, surge_m, sway_ft, heave_m, roll_deg, pitch_rad, yaw_deg, note\n"
                  "0, 0, 10, 0, 0, 0.1, 0, a\n0.5, 1, 0, 2, 3, -0.1, 4, b\n");
    const Scenario scenario = sound("[ship.motion]\nfile = \"motion.csv\"");
    const auto& rows = scenario.ships.at(0).motion.value_or(MotionSection{}).history;
    ASSERT_THAT(rows, SizeIs(2));
    EXPECT_NEAR(rows[0].values[1], 3.048, 1e-12);
    EXPECT_EQ(rows[1].time_s, 0.5);
    EXPECT_NEAR(rows[1].values[3], radians(3.0), 1e-12);
    EXPECT_EQ(rows[1].values[4], -0.1);
    EXPECT_NEAR(rows[1].values[5], -radians(4.0), 1e-12) << "clockwise in the file";
}

TEST(ReportSections, MistakesInATimeHistoryAreToldWhereTheyStand) {
    const auto told = [&](const std::string& csv) {
        folder().file("bad.csv", csv);
        return mistakes("[ship.motion]\nfile = \"bad.csv\"");
    };
    const std::string head = "time_s,surge_m,sway_m,heave_m,roll_deg,pitch_deg,yaw_deg\n";
    EXPECT_THAT(mistakes("[ship.motion]\nfile = \"none.csv\""),
                HasSubstr("none.csv\"; expected a CSV time history"));
    EXPECT_THAT(told(""), HasSubstr("bad.csv:1:1: error: the file is empty"));
    EXPECT_THAT(told(head), HasSubstr("there is no row below the header"));
    EXPECT_THAT(told("time_s,surge_m,sway_m,heave_m,roll,pitch_deg\n0,0,0,0,0,0\n"),
                testing::AllOf(HasSubstr("bad.csv:1:1: error: the header has no column roll_deg or roll_rad"),
                               HasSubstr("no column yaw_deg or yaw_rad")));
    EXPECT_THAT(told(head + "0,0,0,0,0,nan,0\n1,0,inf,0,0,0,0\n2,x,0,0,0,0,0\n"),
                testing::AllOf(HasSubstr("bad.csv:2:11: error: \"nan\" is no finite number"),
                               HasSubstr(":3:5: error: \"inf\""), HasSubstr(":4:3: error: \"x\"")));
    EXPECT_THAT(told(head + "0,0,0,0,0,0\n"),
                HasSubstr(":2:1: error: the row has 6 values; the header has 7 columns"));
    EXPECT_THAT(told(head + "1,0,0,0,0,0,0\n1,0,0,0,0,0,0\n"),
                HasSubstr(":3:1: error: time 1 does not follow 1"));
}

TEST(ReportSections, SeaStatesArePresetsOfTheOceansSun) {
    const Scenario flat = sound("", "", "sea_state = \"0\"");
    EXPECT_NEAR(degrees(flat.suns.at(0).elevation_rad), 90.0, 1e-9);
    EXPECT_TRUE(flat.suns.at(0).turning());
    const Scenario rough = sound("", "", "sea_state = \"3\"\nazimuth_rate_deg_s = 10");
    EXPECT_NEAR(degrees(rough.suns.at(0).elevation_rad), 24.0, 1e-9);
    EXPECT_NEAR(degrees(rough.suns.at(0).azimuth_rate_rad_s), -10.0, 1e-9);
    EXPECT_THAT(mistakes("", "", "sea_state = \"2\""), HasSubstr("expected one of \"0\", \"1-2\", \"3\""));
}

TEST(ReportSections, MistakesInMethodsAreTold) {
    EXPECT_THAT(
        mistakes("occulting = \"boxes\""),
        HasSubstr(
            "expected one of \"none\", \"waterline\", \"priority\", \"box\", \"fitted_box\", \"wedges\""));
    EXPECT_THAT(mistakes("wake = [\"churn\"]"),
                HasSubstr("\"wake\" names \"churn\"; expected \"none\", or some of white_v, "));
    EXPECT_THAT(mistakes("wake = [\"none\", \"solid\"]"), HasSubstr("names \"none\""));
    EXPECT_THAT(mistakes("", "[sea]\nmethod = \"moon\""), HasSubstr("expected one of \"sun\", \"normals\""));
    EXPECT_THAT(mistakes("", "[sea]\nnormals_every = 0"),
                HasSubstr("\"normals_every\" is 0; expected 1 to 60"));
}

TEST(ReportSections, WhatTheDatabaseLacksForAMethodIsToldWhereTheScenarioNamesIt) {
    const Scenario scenario =
        sound("occulting = \"fitted_box\"\nwake = [\"blended_v\", \"cam\"]", "[sea]\nmethod = \"normals\"");
    NameDirectory directory;
    directory.suns = {"ocean"};
    directory.moving_objects = {"lph2"};
    directory.slots = {{"lph2.hull_below", 2}, {"lph2.box", 2}};
    database::Diagnostics diagnostics;
    bind(scenario, directory, diagnostics);
    const std::string text = diagnostics.text();
    EXPECT_THAT(
        text,
        HasSubstr(
            ":19:13: error: \"fitted_box\" cannot be shown: the database lacks 3 alternatives in the slot "
            "\"lph2.box\" (it has 2)"));
    EXPECT_THAT(
        text,
        HasSubstr(
            ":20:8: error: \"blended_v\" cannot be shown: the database lacks the slot \"lph2.v_wake\""));
    EXPECT_THAT(
        text,
        HasSubstr("\"cam\" cannot be shown: the database lacks the moving objects \"lph2.cam_port\" and "
                  "\"lph2.cam_starboard\""));
    EXPECT_THAT(
        text,
        HasSubstr(
            "\"normals\" cannot be shown: the database lacks an object list \"sea\" that repeats a tile"));
    EXPECT_THAT(diagnostics.all(), SizeIs(4));
}

TEST(ReportSections, TheOwnShipOfEachKind) {
    const auto own = [&](const std::string& text) {
        return load_scenario(
            folder().file("own.toml", "[scenario]\nname = \"o\"\ndatabase = \"s.toml\"\nduration_s = 5\n"
                                      "[[channel]]\nname = \"a\"\nhorizontal_field_deg = 60\n" +
                                          text));
    };
    EXPECT_THAT(own("").diagnostics.text(),
                HasSubstr("has no [[approach]]; expected at least one, or [own_ship] of another kind"));
    folder().file("path.csv", "time_s,east_m,north_m,up_m,heading_deg,pitch_deg,roll_deg\n0,1,2,3,90,4,5\n");
    const ScenarioResult path = own("[own_ship]\nkind = \"path\"\nfile = \"path.csv\"\n");
    ASSERT_TRUE(path.scenario) << path.diagnostics.text();
    EXPECT_NEAR(path.scenario->own_ship.path.at(0).values[3], 0.0, 1e-12) << "east";
    const ScenarioResult flown =
        own("[own_ship]\nkind = \"flown\"\nposition_m = [0, 0, 30]\nheading_deg = 0\nspeed_kt = 20\n");
    ASSERT_TRUE(flown.scenario) << flown.diagnostics.text();
    EXPECT_NEAR(flown.scenario->own_ship.heading_rad, pi / 2.0, 1e-12);
    EXPECT_THAT(
        own("[own_ship]\nkind = \"fixed\"\nposition_m = [0, 0, 1]\naim_m = [0, 0, 1]\n").diagnostics.text(),
        HasSubstr("the aim is the eye itself"));
    const ScenarioResult beside =
        own("[own_ship]\nkind = \"fixed\"\nposition_m = [0, 0, 1]\naim_m = [0, 0, 0]\nbeside = \"lph2\"\n");
    ASSERT_TRUE(beside.scenario) << beside.diagnostics.text();
    database::Diagnostics unbound;
    bind(*beside.scenario, {}, unbound);
    EXPECT_THAT(unbound.text(), HasSubstr("no [[ship]] has the moving object \"lph2\""));
}

} // namespace
} // namespace linkdig::host
