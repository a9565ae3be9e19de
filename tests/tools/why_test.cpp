// linkdig why tells of the face that the picture shows, by the planes that decided.

#include "ig/geometry/projected_face.h"
#include "tools/flight/flight.h"

#include <gtest/gtest.h>

namespace linkdig::tools {
namespace {

constexpr std::uint32_t width = 160;
constexpr std::uint32_t height = 120;

FlightRequest request(ig::Scan scan) {
    FlightRequest request;
    request.scenario_path = LINKDIG_SOURCE_DIR "/database/scenes/first_flight/approach.toml";
    request.configuration.raster = {width, height, scan};
    request.configuration.update_rate_hz = 30.0;
    return request;
}

TEST(Why, NamesTheFaceThatThePictureShows) {
    for (const ig::Scan scan : {ig::Scan::horizontal, ig::Scan::vertical}) {
        Flight flight(request(scan));
        flight.machine().draw_planes(true, true);
        flight.draw(500, {});
        const ig::VideoFrame& picture = flight.machine().picture(0);
        for (std::uint32_t row = 0; row < height; row += 3) {
            for (std::uint32_t column = 0; column < width; column += 3) {
                const std::vector<ig::Layer> layers = flight.machine().explain(0, column, row);
                const std::size_t at = std::size_t{row} * width + column;
                ASSERT_FALSE(layers.empty()) << column << "," << row; // sea and sky are everywhere
                ASSERT_EQ(static_cast<std::int32_t>(layers[0].rank), picture.rank[at])
                    << column << "," << row;
                ASSERT_EQ(layers[0].intensity, picture.intensity[at]) << column << "," << row;
                for (std::size_t k = 1; k < layers.size(); ++k)
                    ASSERT_LT(layers[k - 1].rank, layers[k].rank);
            }
        }
    }
}

TEST(Why, PlanesStandOnTheSideThatTheOrderTook) {
    // Of two faces of one list, follow the planes from the root: at the first where their sides differ, the eye's side
    // is the side of the face in front.
    Flight flight(request(ig::Scan::horizontal));
    flight.draw(560, {});
    int decided = 0;
    for (std::uint32_t row = 0; row < height; ++row) {
        for (std::uint32_t column = 0; column < width; ++column) {
            const std::vector<ig::Layer> layers = flight.machine().explain(0, column, row);
            for (std::size_t k = 1; k < layers.size(); ++k) {
                const auto& near = layers[k - 1].planes;
                const auto& far = layers[k].planes;
                if (layers[k - 1].cluster != layers[k].cluster) continue;
                std::size_t p = 0;
                while (p < near.size() && p < far.size() && near[p].side == far[p].side &&
                       near[p].tree == far[p].tree && near[p].distance_m == far[p].distance_m) {
                    ++p;
                }
                if (p == near.size() || p == far.size() || near[p].normal != far[p].normal ||
                    near[p].distance_m != far[p].distance_m) {
                    continue;
                }
                using Side = ig::PlaneTaken::Side;
                const Side eye = near[p].eye_in_front ? Side::front : Side::back;
                EXPECT_TRUE(near[p].side == eye || (near[p].side == Side::on && far[p].side != eye))
                    << column << "," << row;
                ++decided;
            }
        }
    }
    EXPECT_GT(decided, 100);
}

TEST(Why, HasNothingToSayBeyondThePicture) {
    Flight flight(request(ig::Scan::horizontal));
    EXPECT_TRUE(flight.machine().explain(0, 1, 1).empty()); // nothing was drawn yet
    flight.draw(0, {});
    EXPECT_TRUE(flight.machine().explain(0, width, 0).empty());
    EXPECT_TRUE(flight.machine().explain(0, 0, height).empty());
    EXPECT_TRUE(flight.machine().explain(1, 0, 0).empty());
}

} // namespace
} // namespace linkdig::tools
