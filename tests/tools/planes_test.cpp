#include "tools/flight/planes.h"

#include "tests/tools/pictures.h"
#include "tools/flight/flight.h"

#include <OpenImageIO/imageio.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <set>
#include <utility>

namespace linkdig::tools {
namespace {

/// A frame of the shipped flight, near the ship, with its planes.
class PlanesOfTheFlight : public testing::Test {
protected:
    static void SetUpTestSuite() {
        FlightRequest request;
        request.scenario_path = LINKDIG_SOURCE_DIR "/database/scenes/first_flight/approach.toml";
        request.configuration.raster = {.width = 160, .height = 120};
        request.configuration.update_rate_hz = 30.0;
        flight_ = std::make_unique<Flight>(request);
        flight_->machine().draw_planes(true, true);
        flight_->draw(500, {});
    }
    static void TearDownTestSuite() { flight_.reset(); }
    static const ig::VideoFrame& picture() { return flight_->machine().picture(0); }
    static std::vector<std::uint32_t> plane(ig::Plane which) {
        return numbers(which, flight_->database(), flight_->machine(), 0);
    }
    static inline std::unique_ptr<Flight> flight_;
};

TEST_F(PlanesOfTheFlight, EveryNumberIsAnIndexOrAMark) {
    const VisualDatabase& database = flight_->database();
    const auto rank = plane(ig::Plane::rank);
    const auto list = plane(ig::Plane::list);
    const auto object = plane(ig::Plane::object);
    const auto face = plane(ig::Plane::face);
    ASSERT_EQ(rank.size(), 160U * 120U);
    for (std::size_t pixel = 0; pixel < rank.size(); ++pixel) {
        if (rank[pixel] == no_face) {
            EXPECT_EQ((std::set{list[pixel], object[pixel], face[pixel]}), std::set{no_face});
            continue;
        }
        ASSERT_LT(list[pixel], database.lists.size());
        if (face[pixel] == made_face) {
            EXPECT_NE(database.lists[list[pixel]].tile, none);
            continue;
        }
        ASSERT_LT(face[pixel], database.faces.size());
        EXPECT_EQ(database.faces[face[pixel]].object, object[pixel]);
        EXPECT_EQ(database.objects[object[pixel]].list, list[pixel]);
    }
}

TEST_F(PlanesOfTheFlight, SeaShipAndSkyAreSeen) {
    const auto list = plane(ig::Plane::list);
    EXPECT_GE((std::set<std::uint32_t>(list.begin(), list.end()).size()), 3U);
    EXPECT_NE(std::ranges::count(plane(ig::Plane::face), made_face), 0);
}

TEST_F(PlanesOfTheFlight, ColourIsColourCodeTimesIntensity) {
    const auto face = plane(ig::Plane::face);
    const auto intensity = intensities(picture().intensity);
    const VisualDatabase& database = flight_->database();
    for (std::size_t pixel = 0; pixel < face.size(); ++pixel) {
        if (face[pixel] >= database.faces.size()) continue;
        const Colour& code = database.colours[database.faces[face[pixel]].colour];
        const std::uint32_t seen = picture().pixels[pixel];
        EXPECT_NEAR(static_cast<float>(code.red) * intensity[pixel], static_cast<float>(seen & 255U), 0.51F);
        EXPECT_NEAR(static_cast<float>(code.blue) * intensity[pixel], static_cast<float>(seen >> 16U & 255U),
                    0.51F);
    }
}

TEST_F(PlanesOfTheFlight, FilesAreNamedByPlaneAndFrame) {
    const TemporaryFolder folder;
    for (const ig::Plane which : parse_planes("colour,intensity,rank,list,object,face"))
        write_plane(which, flight_->database(), flight_->machine(), 0, folder.text(), 10);
    for (const char* name : {"colour_000010.png", "intensity_000010.exr", "rank_000010.exr",
                             "list_000010.exr", "object_000010.exr", "face_000010.exr"})
        EXPECT_TRUE(std::filesystem::exists(folder.file(name))) << name;
    const auto input = OIIO::ImageInput::open(folder.file("face_000010.exr"));
    ASSERT_TRUE(input);
    std::vector<std::uint32_t> read(160U * 120U);
    ASSERT_TRUE(input->read_image(0, 0, 0, 1, OIIO::TypeDesc::UINT32, read.data()));
    EXPECT_EQ(read, plane(ig::Plane::face));
}

} // namespace
} // namespace linkdig::tools
