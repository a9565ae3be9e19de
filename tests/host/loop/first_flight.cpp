#include "tests/host/loop/first_flight.h"

#include <gtest/gtest.h>

namespace linkdig::host {

NameDirectory first_flight_names() {
    NameDirectory names;
    names.database_id = 0x1234;
    names.suns = {"world", "ocean", "sky", "churn"};
    names.moving_objects = {"launch", "lph2"};
    names.slots = {{"lph2.bow_wake_starboard", 29}, {"flag", 3}, {"lph2.bow_wake_port", 29}};
    names.lists = {{"sea", 1, 0.35F, 0.65F}, {"sky", 2, 0.4F, 0.6F}, {"lph2.upper", 0, 0.45F, 0.55F}};
    for (const char* band : {"0 to 2", "2 to 4.5", "4.5 to 8", "8 to 12", "12 to 17", "17 to 23", "23 to 30",
                             "30 to 39", "39 to 50", "50 to 64", "64 to 90"})
        names.colours.push_back(std::string("sky ") + band);
    names.colours.emplace_back("deck");
    names.colour_codes.assign(names.colours.size(), Colour{180, 200, 220, 0});
    return names;
}

Scenario first_flight_scenario() {
    const ScenarioResult result =
        load_scenario(LINKDIG_SOURCE_DIR "/database/scenes/first_flight/approach.toml");
    EXPECT_EQ(result.diagnostics.text(), "");
    return result.scenario.value_or(Scenario{});
}

} // namespace linkdig::host
