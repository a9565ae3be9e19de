#include "host/scenario/bind.h"
#include "host/scenario/scenario.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>

namespace linkdig::host {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

/// Without mistakes; tests add lines to it or replace some.
const std::string sound = R"([scenario]
name = "test"
database = "../scenes/sea.toml"
duration_s = 20
[suns.ocean]
azimuth_deg = 90
elevation_deg = 30
azimuth_rate_deg_s = 72
[[ship]]
moving_object = "lph2"
heading_deg = 20
speed_kt = 12
[ship.motion]
significant_height_m = 2.5
period_s = 12
seas_from_deg = 60
[[sequence]]
slot = "wake"
dwell_s = 0.1
[[approach]]
ship = "lph2"
duration_s = 20
path_m = [[0, 0, 1], [1, 0, 1], [2, 0, 1], [3, 0, 1]]
first_aim_m = [0, 0, 0]
last_aim_m = [0, 0, 0]
[[channel]]
name = "ahead"
horizontal_field_deg = 60
)";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

/// A file of this process alone (tests run side by side) that goes when the process ends.
struct ScratchFile {
    const std::string path = testing::TempDir() + "linkdig-scenario-" + std::to_string(::getpid()) + ".toml";
    ~ScratchFile() { std::filesystem::remove(path); }
};

std::string written(const std::string& text) {
    static const ScratchFile file;
    std::ofstream(file.path) << text;
    return file.path;
}

ScenarioResult loaded(const std::string& text) { return load_scenario(written(text)); }

struct Mistake {
    std::string from;
    std::string to;
    std::string place; ///< ":line:column:"
    std::string message;
};

class Mistakes : public testing::TestWithParam<Mistake> {};

TEST_P(Mistakes, IsToldWhereItStands) {
    const std::string path = written(replaced(sound, GetParam().from, GetParam().to));
    const ScenarioResult result = load_scenario(path);
    EXPECT_FALSE(result.scenario.has_value());
    EXPECT_THAT(result.diagnostics.all(), SizeIs(1)) << result.diagnostics.text();
    EXPECT_THAT(result.diagnostics.text(),
                HasSubstr(path + GetParam().place + " error: " + GetParam().message));
}

INSTANTIATE_TEST_SUITE_P(
    Scenario, Mistakes,
    testing::Values(
        Mistake{"name = \"test\"\n", "", ":1:1:", "[scenario] lacks the key \"name\""},
        Mistake{"duration_s = 20\n", "duration_s = -1\n",
                ":4:14:", "\"duration_s\" is -1; expected 0.1 to 86400"},
        Mistake{"duration_s = 20\n", "duration_min = 20\nduration_s = 20\n",
                ":4:1:", "unknown key \"duration_min\" in [scenario]"},
        Mistake{"../scenes/sea.toml", "sea.obj",
                ":3:12:", "\"database\" is \"sea.obj\"; expected a .toml or .igdb file"},
        Mistake{"elevation_deg = 30", "elevation_deg = 89", ":7:17:",
                "\"elevation_deg\" is 89; a turning sun stands between \"least_elevation_deg\" 5 and "
                "\"greatest_elevation_deg\" 85"},
        Mistake{"azimuth_rate_deg_s = 72", "least_elevation_deg = 80\ngreatest_elevation_deg = 10",
                ":8:23:", "\"least_elevation_deg\" is above \"greatest_elevation_deg\""},
        Mistake{"azimuth_rate_deg_s = 72", "azimuth_rate_deg_s = \"fast\"",
                ":8:22:", "\"azimuth_rate_deg_s\" is a text; expected a finite number"},
        Mistake{"azimuth_rate_deg_s", "azimut_rate_deg_s", ":8:1:",
                "unknown key \"azimut_rate_deg_s\" in [suns.ocean]; did you mean \"azimuth_rate_deg_s\"?"},
        Mistake{"[suns.ocean]", "[suns]\nhigh = 3\n[suns.ocean]",
                ":6:8:", "\"suns.high\" is no table; expected [suns.high]"},
        Mistake{"speed_kt = 12\n", "speed_kt = 12\nspeed_mps = 6\n",
                ":13:13:", "both \"speed_kt\" and \"speed_mps\" stand in [[ship]]"},
        Mistake{"speed_kt = 12\n", "", ":9:1:", "[[ship]] lacks the key \"speed_kt\" or \"speed_mps\""},
        Mistake{"period_s = 12", "period_s = 300", ":15:12:", "\"period_s\" is 300; expected 2 to 30"},
        Mistake{"[[sequence]]\n", "[[sequence]]\nslot = \"wake\"\ndwell_s = 0.2\n[[sequence]]\n",
                ":21:8:", "a second [[sequence]] for \"wake\"; the first stands in line 18"},
        Mistake{"dwell_s = 0.1", "dwell_s = 0", ":19:11:", "\"dwell_s\" is 0; expected 0.001 to 3600"},
        Mistake{", [3, 0, 1]]", "]",
                ":23:10:", "the path has 3 points; expected 4: start, two handles, hover"},
        Mistake{"[[approach]]", "[approach]",
                ":20:1:", "\"approach\" is a table; expected an array of tables: [[approach]]"},
        Mistake{"horizontal_field_deg = 60", "horizontal_field_deg = 180",
                ":28:24:", "\"horizontal_field_deg\" is 180; expected 1 to 150"},
        Mistake{"[[channel]]\nname = \"ahead\"\nhorizontal_field_deg = 60\n", "",
                ":1:1:", "the scenario has 0 channels; expected 1 to 8"},
        Mistake{"[[channel]]", "[sky]\nrgb = [0, 300, 0]\n[[channel]]",
                ":27:7:", "\"rgb\" has the component 300; expected 0 to 255"},
        Mistake{"[[channel]]", "[[channel]]\nname = \"ahead\"\nhorizontal_field_deg = 50\n[[channel]]",
                ":30:8:", "a second [[channel]] for \"ahead\"; the first stands in line 27"},
        Mistake{"speed_kt = 12\n", "speed_kt = 12\nwake = []\n",
                ":13:8:", "\"wake\" names nothing; expected \"none\", or some of "},
        Mistake{"[[channel]]", "[sea]\nstates = 2\n[[channel]]",
                ":27:1:", "unknown key \"states\" in [sea]; did you mean \"state\"?"},
        Mistake{"[[channel]]", "[fog]\n[[channel]]", ":26:2:", "unknown key \"fog\" in the scenario"}));

TEST(LoadScenario, EveryMistakeOfAFileIsToldAtOnce) {
    std::string text = replaced(sound, "duration_s = 20\n", "duration_s = true\n");
    text = replaced(text, "heading_deg = 20", "heading_deg = 400");
    text = replaced(text, "slot = \"wake\"\n", "");
    text = replaced(text, "name = \"ahead\"", "name = 7");
    const ScenarioResult result = loaded(text);
    EXPECT_FALSE(result.scenario.has_value());
    EXPECT_THAT(result.diagnostics.all(), SizeIs(4)) << result.diagnostics.text();
}

/// What comes of a value that was refused is no second mistake.
TEST(LoadScenario, EachMistakeIsToldOnce) {
    for (const auto& [from, to] :
         {std::pair("[3, 0, 1]]", "[3, nan, 1]]"), std::pair("[3, 0, 1]]", "3]"),
          std::pair("elevation_deg = 30", "elevation_deg = 500"),
          std::pair("elevation_deg = 30", "elevation_deg = 30\nleast_elevation_deg = 500")})
        EXPECT_THAT(loaded(replaced(sound, from, to)).diagnostics.all(), SizeIs(1)) << to;
    // "position_m" and "aim_m" are missing, and no aim is the eye.
    EXPECT_THAT(loaded(sound + "[own_ship]\nkind = \"fixed\"\n").diagnostics.all(), SizeIs(2));
}

TEST(LoadScenario, MissingEmptyAndBrokenFiles) {
    const ScenarioResult missing = load_scenario("/nonexistent/scenario.toml");
    EXPECT_FALSE(missing.scenario.has_value());
    EXPECT_THAT(missing.diagnostics.text(), HasSubstr("/nonexistent/scenario.toml"));
    const ScenarioResult empty = loaded("");
    EXPECT_FALSE(empty.scenario.has_value());
    EXPECT_THAT(empty.diagnostics.text(), HasSubstr("the table [scenario] is missing"));
    EXPECT_THAT(empty.diagnostics.text(), HasSubstr("no [[approach]]"));
    EXPECT_THAT(empty.diagnostics.text(), HasSubstr("0 channels"));
    EXPECT_FALSE(loaded("[scenario\n").scenario.has_value());
    EXPECT_THAT(loaded("scenario = 3\n").diagnostics.text(),
                HasSubstr("\"scenario\" is a whole number; expected a table"));
}

TEST(LoadScenario, NineChannelsAreOneTooMany) {
    std::string text = sound;
    for (int i = 0; i < 8; ++i)
        text += "[[channel]]\nname = \"more\"\nhorizontal_field_deg = 40\n";
    EXPECT_THAT(loaded(text).diagnostics.text(), HasSubstr("the scenario has 9 channels; expected 1 to 8"));
}

TEST(LoadScenario, UnitsBecomeSiAndAviationHeadingsMathematical) {
    const ScenarioResult result = loaded(sound);
    ASSERT_TRUE(result.scenario.has_value()) << result.diagnostics.text();
    const Scenario& scenario = *result.scenario;
    EXPECT_EQ(scenario.name, "test");
    EXPECT_THAT(scenario.database_path, HasSubstr("/scenes/sea.toml"));
    EXPECT_EQ(scenario.database_path.find(".."), std::string::npos) << scenario.database_path;
    const SunSection& ocean = scenario.suns.front();
    EXPECT_EQ(ocean.sun.text, "ocean");
    EXPECT_NEAR(ocean.azimuth_rad, 0.0, 1e-12) << "90 degrees clockwise from north is east";
    EXPECT_NEAR(ocean.azimuth_rate_rad_s, -1.2566370614359172, 1e-12) << "clockwise";
    EXPECT_TRUE(ocean.turning());
    const ShipSection& ship = scenario.ships.front();
    EXPECT_NEAR(ship.heading_rad, 1.2217304763960306, 1e-12) << "020 is 70 degrees from east";
    EXPECT_NEAR(ship.speed_mps, 12.0 * 1852.0 / 3600.0, 1e-12);
    ASSERT_TRUE(ship.motion.has_value());
    EXPECT_NEAR(std::cos(ship.motion->travel_heading_rad), -std::cos(radians(30.0)), 1e-12)
        << "seas from 060 run to 240";
    EXPECT_NEAR(ship.motion->axes[3].limit, radians(8.0), 1e-12);
    EXPECT_FALSE(scenario.channels.front().vertical_field_rad.has_value());
    EXPECT_EQ(scenario.visibility_m, 0.0);
}

TEST(LoadScenario, FeetAreFeet) {
    const ScenarioResult result = loaded(replaced(sound, "path_m = [[0, 0, 1],", "path_ft = [[0, 0, 100],"));
    ASSERT_TRUE(result.scenario.has_value()) << result.diagnostics.text();
    EXPECT_NEAR(result.scenario->approaches[0].path_m[0].z, 30.48, 1e-12);
}

TEST(LoadScenario, ApproachNeedsNoShip) {
    const ScenarioResult result = loaded(replaced(sound, "[[approach]]\nship = \"lph2\"", "[[approach]]"));
    ASSERT_TRUE(result.scenario.has_value()) << result.diagnostics.text();
    EXPECT_EQ(result.scenario->approaches[0].ship.text, "");
}

TEST(ApproachFor, TheLongestThatFitsElseTheShortest) {
    Scenario scenario;
    for (const double duration : {20.0, 60.0}) {
        ApproachSection approach;
        approach.duration_s = duration;
        scenario.approaches.push_back(approach);
    }
    for (const auto& [length, chosen] :
         {std::pair(5.0, 20.0), {20.0, 20.0}, {59.0, 20.0}, {60.0, 60.0}, {900.0, 60.0}}) {
        scenario.duration_s = length;
        EXPECT_EQ(approach_for(scenario).duration_s, chosen) << length;
    }
}

class Bind : public testing::Test {
protected:
    Scenario scenario() {
        return loaded(sound + "[sky]\nlists = [\"dome\"]\nbands = [\"low\", \"high\"]\n").scenario.value();
    }
    NameDirectory names() {
        NameDirectory directory;
        directory.suns = {"ocean"};
        directory.moving_objects = {"tug", "lph2"};
        directory.slots = {{"flag", 2}, {"smoke", 4}, {"wake", 28}};
        directory.lists = {{"sea", 0, 0, 1}, {"dome", 0, 0, 1}};
        directory.colours = {"high", "grey", "low"};
        return directory;
    }
};

TEST_F(Bind, NamesBecomeIndices) {
    database::Diagnostics diagnostics;
    const Binding binding = bind(scenario(), names(), diagnostics);
    EXPECT_EQ(diagnostics.text(), "");
    EXPECT_THAT(binding.suns, ElementsAre(0));
    EXPECT_THAT(binding.ships, ElementsAre(1));
    EXPECT_THAT(binding.slots, ElementsAre(2));
    EXPECT_THAT(binding.slot_alternatives, ElementsAre(28));
    EXPECT_THAT(binding.sky_lists, ElementsAre(1));
    EXPECT_THAT(binding.sky_bands, ElementsAre(2, 0));
    EXPECT_EQ(binding.sun_count, 1U);
    EXPECT_EQ(binding.moving_object_count, 2U);
}

TEST_F(Bind, UnknownNamesAreToldWithTheNearestOrAll) {
    NameDirectory directory = names();
    directory.suns = {"ocaen", "world"};
    directory.moving_objects = {};
    directory.slots = {{"flag", 2}, {"smoke", 4}};
    directory.lists = {{"dom", 0, 0, 1}};
    database::Diagnostics diagnostics;
    bind(scenario(), directory, diagnostics);
    const std::string text = diagnostics.text();
    EXPECT_THAT(text,
                HasSubstr(".toml:5:1: error: the database has no sun \"ocean\"; did you mean \"ocaen\"?"));
    EXPECT_THAT(text, HasSubstr("error: the database's sun \"world\" stands nowhere; expected [suns.world]"));
    EXPECT_THAT(text, HasSubstr(":10:17: error: the database has no moving object \"lph2\"; it has none"));
    EXPECT_THAT(
        text, HasSubstr(":18:8: error: the database has no substitution slot \"wake\"; it has: flag, smoke"));
    EXPECT_THAT(text, HasSubstr("error: the database has no object list \"dome\"; did you mean \"dom\"?"));
}

TEST_F(Bind, AShipThatIsNamedHasASection) {
    const auto told = [&](const std::string& text) {
        database::Diagnostics diagnostics;
        bind(loaded(text).scenario.value(), names(), diagnostics);
        return diagnostics.text();
    };
    const std::string with_sky = sound + "[sky]\nbands = [\"low\"]\n";
    EXPECT_THAT(told(replaced(with_sky, "ship = \"lph2\"", "ship = \"tug\"")),
                testing::EndsWith(".toml:21:8: error: no [[ship]] has the moving object \"tug\"\n"));
    EXPECT_THAT(told(replaced(with_sky, "moving_object = \"lph2\"", "moving_object = \"lhp2\"")),
                testing::MatchesRegex(
                    "[^\n]*\\.toml:10:17: error: the database has no moving object \"lhp2\"; did you mean "
                    "\"lph2\"\\?\n"))
        << "the ship alone, and not the approach to her";
}

} // namespace
} // namespace linkdig::host
