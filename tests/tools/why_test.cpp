// linkdig why tells of the face that the picture shows, by the planes that decided.

#include "ig/geometry/projected_face.h"
#include "tools/flight/flight.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <utility>

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

std::vector<ig::Layer> layers_of(Flight& flight, std::uint32_t column, std::uint32_t row) {
    auto reasons = flight.machine().explain(0, column, row);
    return reasons ? std::move(reasons->layers) : std::vector<ig::Layer>{};
}

TEST(Why, NamesTheFaceThatThePictureShows) {
    for (const ig::Scan scan : {ig::Scan::horizontal, ig::Scan::vertical}) {
        Flight flight(request(scan));
        flight.machine().draw_planes(true, true);
        flight.draw(500, {});
        const ig::VideoFrame& picture = flight.machine().picture(0);
        for (std::uint32_t row = 0; row < height; row += 3) {
            for (std::uint32_t column = 0; column < width; column += 3) {
                const std::vector<ig::Layer> layers = layers_of(flight, column, row);
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
            const std::vector<ig::Layer> layers = layers_of(flight, column, row);
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

/// The pixel put together again from its parts, in levels.
std::array<double, 3> put_together(const ig::PixelReasons& reasons) {
    std::array<double, 3> sum{};
    std::map<std::int32_t, std::array<double, 3>> waiting; // by the list that it falls on
    for (const ig::PixelShare& share : reasons.make_up.shares) {
        const std::array<double, 3> levels{share.seen.light.red / 128.0, share.seen.light.green / 128.0,
                                           share.seen.light.blue / 128.0};
        const double part = share.weight / static_cast<double>(ig::whole_pixel);
        const auto layer = std::ranges::find(reasons.layers, share.rank, &ig::Layer::rank);
        for (std::size_t k = 0; k < 3; ++k) {
            if (share.added_to >= 0) {
                if (!share.falls_on_none) waiting[share.added_to][k] += part * levels[k];
                continue;
            }
            const double more =
                layer == reasons.layers.end() ? 0.0 : waiting[static_cast<std::int32_t>(layer->list)][k];
            sum[k] += part * std::min(255.0, levels[k] + more);
        }
    }
    for (const ig::PixelLight& light : reasons.make_up.lights)
        for (std::size_t k = 0; k < 3; ++k)
            sum[k] += light.levels[k];
    return sum;
}

/// A frame, and what must be in it so that it shows something.
struct MadeOf {
    const char* scenario;
    std::uint64_t frame;
    bool lights;    ///< light points
    bool air;       ///< limited visibility
    bool additions; ///< light of additive faces
};

// Smoothed edges, haze, the packet's own colours by night, light points, wakes that are added to the sea.
TEST(Why, ThePartsOfAPixelAddUpToIt) {
    for (const MadeOf& each : {MadeOf{"first_flight/approach.toml", 500, false, false, false},
                               MadeOf{"plattsburgh/approach.toml", 100, false, true, false},
                               MadeOf{"pease/night.toml", 100, true, true, false},
                               MadeOf{"two_ships/figure_of_eight.toml", 3018, false, false, true}}) {
        FlightRequest asked = request(ig::Scan::vertical);
        asked.scenario_path = std::string(LINKDIG_SOURCE_DIR "/database/scenes/") + each.scenario;
        asked.configuration.edge_smoothing = true;
        Flight flight(asked);
        flight.lead_in(each.frame, {});
        flight.draw(each.frame, {});
        const ig::VideoFrame& picture = flight.machine().picture(0);
        bool lights = false, air = false, additions = false, shared = false;
        for (std::uint32_t row = 0; row < height; row += 2)
            for (std::uint32_t column = 0; column < width; column += 3) {
                const auto reasons = flight.machine().explain(0, column, row);
                ASSERT_TRUE(reasons.has_value());
                const std::array<double, 3> sum = put_together(*reasons);
                const std::uint32_t pixel = picture.pixels[std::size_t{row} * width + column];
                for (std::uint32_t k = 0; k < 3; ++k)
                    ASSERT_NEAR(std::min(255.0, sum[k]), pixel >> (8 * k) & 0xffU, 1.01)
                        << each.scenario << " at " << column << "," << row << ", component " << k;
                lights = lights || !reasons->make_up.lights.empty();
                shared = shared || reasons->make_up.shares.size() > 1;
                for (const ig::PixelShare& share : reasons->make_up.shares) {
                    air = air || share.seen.transmission >= 0;
                    additions = additions || (share.added_to >= 0 && !share.falls_on_none);
                }
            }
        EXPECT_TRUE(shared) << each.scenario;
        EXPECT_TRUE(lights || !each.lights) << each.scenario;
        EXPECT_TRUE(air || !each.air) << each.scenario;
        EXPECT_TRUE(additions || !each.additions) << each.scenario;
    }
}

TEST(Why, HasNothingToSayBeyondThePicture) {
    Flight flight(request(ig::Scan::horizontal));
    EXPECT_FALSE(flight.machine().explain(0, 1, 1).has_value()); // nothing was drawn yet
    flight.draw(0, {});
    EXPECT_FALSE(flight.machine().explain(0, width, 0).has_value());
    EXPECT_FALSE(flight.machine().explain(0, 0, height).has_value());
    EXPECT_FALSE(flight.machine().explain(1, 0, 0).has_value());
}

} // namespace
} // namespace linkdig::tools
