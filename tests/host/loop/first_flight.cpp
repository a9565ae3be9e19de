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
    return names;
}

Scenario first_flight_scenario() {
    const ScenarioResult result =
        load_scenario(LINKDIG_SOURCE_DIR "/database/scenes/first_flight/approach.toml");
    EXPECT_EQ(result.diagnostics.text(), "");
    return result.scenario.value_or(Scenario{});
}

} // namespace linkdig::host
