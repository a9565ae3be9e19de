// Every shipped scenario can be flown: it loads, binds to its database, and the machine takes its packets.

#include "tools/flight/flight.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace linkdig::tools {
namespace {

class ShippedScenario : public testing::TestWithParam<const char*> {};

TEST_P(ShippedScenario, ShowsSomethingInEveryChannel) {
    FlightRequest request;
    request.scenario_path = std::string(LINKDIG_SOURCE_DIR "/database/scenes/") + GetParam();
    request.configuration = ig::ames_profile();
    request.configuration.raster.width = 96;
    request.configuration.raster.height = 72;
    Flight flight(request);
    ASSERT_FALSE(flight.scenario().channels.empty());
    for (const std::uint64_t frame : {std::uint64_t{0}, flight.loop().frames() - 1}) {
        const FrameReport& report = flight.draw(frame, {});
        EXPECT_TRUE(report.errors.empty());
        for (std::size_t c = 0; c < flight.scenario().channels.size(); ++c) {
            const std::vector<std::uint32_t>& pixels = flight.machine().picture(c).pixels;
            ASSERT_EQ(pixels.size(), 96U * 72U) << "channel " << c;
            EXPECT_NE(*std::min_element(pixels.begin(), pixels.end()),
                      *std::max_element(pixels.begin(), pixels.end()))
                << "channel " << c << " of frame " << frame << " is blank";
        }
    }
}

INSTANTIATE_TEST_SUITE_P(All, ShippedScenario,
                         testing::Values("first_flight/approach.toml", "first_flight/four_windows.toml",
                                         "runway_lights/night_approach.toml", "two_ships/in_company.toml",
                                         "two_ships/night_in_company.toml", "two_ships/figure_of_eight.toml",
                                         "pier/wash.toml", "pease/approach.toml", "plattsburgh/night.toml",
                                         "pier/passing.toml", "report/two_waves.toml", "report/plane.toml"));

} // namespace
} // namespace linkdig::tools
