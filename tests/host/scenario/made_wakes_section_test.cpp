// What a scenario may say about wakes that the machine makes, and what it is told when it says something else.

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

const std::string head = R"([scenario]
name = "test"
database = "sea.toml"
duration_s = 20
[[channel]]
name = "ahead"
horizontal_field_deg = 60
[own_ship]
kind = "fixed"
position_m = [0, 0, 10]
aim_m = [100, 0, 0]
)";

ScenarioResult loaded(const std::string& text) {
    const auto path = std::filesystem::temp_directory_path() /
                      ("linkdig-made-wakes-" + std::to_string(::getpid()) + ".toml");
    std::ofstream(path) << head << text;
    ScenarioResult result = load_scenario(path.string());
    std::filesystem::remove(path);
    return result;
}

std::string ship(const std::string& keys) {
    return "[[ship]]\nmoving_object = \"lph2\"\nheading_deg = 20\nspeed_kt = 12\n" + keys + "\n";
}

TEST(MadeWakesSection, IsRead) {
    const ScenarioResult result = loaded(
        ship("wake = [\"kelvin\", \"wave_particles\"]\n[ship.water]\nkelvin_faces = 512\nkelvin_age_s = "
             "60.0\nparticle_faces = 900\nstrength = 2.0\nheights = true\nlength_ft = 100.0\nbeam_m = 9.0") +
        "[[quay]]\nfrom_m = [0, 0]\nto_m = [0, 250]\n");
    ASSERT_TRUE(result.scenario) << result.diagnostics.text();
    const WaterSection& water = result.scenario->ships.at(0).methods.water;
    EXPECT_EQ(water.kelvin_faces, 512U);
    EXPECT_EQ(water.kelvin_age_s, 60.0);
    EXPECT_EQ(water.particle_faces, 900U);
    EXPECT_EQ(water.strength, 2.0);
    EXPECT_TRUE(water.heights);
    EXPECT_NEAR(water.length_m, 30.48, 1e-9);
    EXPECT_EQ(water.beam_m, 9.0);
    ASSERT_EQ(result.scenario->quays.size(), 1U);
    EXPECT_EQ(result.scenario->quays[0].to_m, Vec2d(0.0, 250.0));
}

TEST(MadeWakesSection, MistakesAreToldWithTheirLine) {
    struct Case {
        std::string text;
        const char* told;
    };
    for (const Case& each : {
             Case{ship("wake = [\"kelvin\", \"bow\"]"),
                  ":16:8: error: \"wake\" names \"bow\"; expected \"none\", or some of white_v"},
             Case{ship("wake = 3"), ":16:8: error: \"wake\" is "},
             Case{ship("wake = \"kelvin\"\n[ship.water]\nkelvin_age_s = 0.0"),
                  ":18:16: error: \"kelvin_age_s\" is 0; expected "},
             Case{ship("wake = \"kelvin\"\n[ship.water]\nkelvin_age_s = nan"),
                  ":18:16: error: \"kelvin_age_s\""},
             Case{ship("wake = \"kelvin\"\n[ship.water]\nkelvin_age_min = 3.0"),
                  ":18:1: error: unknown key \"kelvin_age_min\""},
             Case{ship("wake = \"kelvin\"\n[ship.water]\nkelvin_faces = 1000000000"),
                  ":18:16: error: \"kelvin_faces\" is 1000000000; expected "},
             Case{ship("wake = \"kelvin\"\n[ship.water]\nkelvin_faces = \"many\""),
                  ":18:16: error: \"kelvin_faces\" is "},
             Case{ship("[ship.water]\nstrength = -1.0"), ":17:12: error: \"strength\" is -1; expected "},
             Case{ship("[ship.water]\nheights = 1"), ":17:11: error: \"heights\" is "},
             Case{ship("[ship.water]\nlength_km = 1.0"), ":17:1: error: unknown key \"length_km\""},
             Case{ship("[ship.water]\nbeam_m = 0.0"), ":17:10: error: \"beam_m\" is 0; expected "},
             Case{ship("") + "[[quay]]\nfrom_m = [1, 2]\nto_m = [1, 2]",
                  "error: the quay has no length; expected two different places"},
             Case{ship("") + "[[quay]]\nfrom_m = [1, 2]\nto_m = [1, nan]", "error: \"to_m\""},
             Case{ship("") + "[[quay]]\nfrom_m = [1, 2]", "to_m"},
         }) {
        const ScenarioResult result = loaded(each.text);
        EXPECT_FALSE(result.scenario) << each.text;
        EXPECT_THAT(result.diagnostics.text(), HasSubstr(each.told)) << each.text;
    }
}

TEST(MadeWakesSection, WhatTheDatabaseLacksIsToldWhereTheMethodIsNamed) {
    const ScenarioResult kelvin = loaded(ship("wake = [\"kelvin\", \"wave_particles\"]"));
    ASSERT_TRUE(kelvin.scenario) << kelvin.diagnostics.text();
    database::NameDirectory directory;
    directory.moving_objects = {"lph2"};
    const auto told = [&] {
        database::Diagnostics diagnostics;
        bind(*kelvin.scenario, directory, diagnostics);
        return diagnostics.text();
    };
    EXPECT_THAT(told(), HasSubstr(":16:8: error: \"kelvin\" cannot be shown: the database lacks the list "
                                  "\"lph2.kelvin\""));
    directory.lists = {{.name = "lph2.kelvin"}, {.name = "lph2.wave_particles"}};
    EXPECT_THAT(told(),
                HasSubstr("\"kelvin\" cannot be shown: the database lacks the colour \"wake light\""));
    EXPECT_THAT(told(), HasSubstr("\"wave_particles\" cannot be shown: the database lacks the list "
                                  "\"lph2.hull_below\""));
}

} // namespace
} // namespace linkdig::host
