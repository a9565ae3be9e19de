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

TEST(Planes, EdgesAreDrawnWhereAnotherFaceBegins) {
    ig::VideoFrame picture;
    picture.width = 4;
    picture.height = 2;
    picture.pixels = {0xff101010U, 0xff101010U, 0xffe0e0e0U, 0xffe0e0e0U,
                      0xff101010U, 0xff101010U, 0xffe0e0e0U, 0xffe0e0e0U};
    picture.rank = {5, 5, 7, 7, 5, 5, 7, none};
    const std::uint32_t white = 0xffffffffU, black = 0xff000000U;
    EXPECT_EQ(edges_over(picture), (std::vector<std::uint32_t>{0xff101010U, white, 0xffe0e0e0U, black,
                                                               0xff101010U, white, black, 0xffe0e0e0U}));
}

/// Flat colours are those of a machine whose smooth shading is switched off, where no edge is smoothed.
TEST_F(PlanesOfTheFlight, FlatIsTheFlightWithoutSmoothShading) {
    const VisualDatabase& database = flight_->database();
    FramePacket packet = flight_->packet();
    packet.visibility_m = 0;
    std::vector<ListLighting> lighting;
    for (std::uint32_t list = 0; list < database.lists.size(); ++list) {
        const ObjectList& of = database.lists[list];
        ListLighting row{.list = list, .sun = of.sun, .ambient = of.ambient, .diffuse = of.diffuse};
        for (const ListLighting& sent : packet.lighting)
            if (sent.list == list) row = sent;
        if (of.attachment != Attachment::eye) row.method = ShadingMethod::no_smooth;
        lighting.push_back(row);
    }
    ig::Configuration configuration;
    configuration.raster = {.width = 160, .height = 120};
    ig::Machine smooth(database, configuration), flat(database, configuration);
    smooth.draw_planes(false, true);
    smooth.frame(packet);
    packet.lighting = lighting;
    flat.frame(packet);
    const std::vector<std::uint32_t> colours = flat_colours(database, smooth, 0);
    std::size_t differing = 0, blended = 0;
    for (std::size_t at = 0; at < colours.size(); ++at) {
        const std::int32_t rank = smooth.picture(0).rank[at];
        if (rank != none && smooth.source(0, rank).face->opacity < 256) {
            ++blended;
            continue;
        }
        differing += colours[at] != flat.picture(0).pixels[at] ? 1 : 0;
    }
    EXPECT_LE(differing, colours.size() / 200); // additive and semi-opaque neighbours
    EXPECT_LT(blended, colours.size() / 2);
}

TEST_F(PlanesOfTheFlight, FilesAreNamedByPlaneAndFrame) {
    const TemporaryFolder folder;
    for (const ig::Plane which : parse_planes("colour,intensity,rank,list,object,face,edges,flat"))
        write_plane(which, flight_->database(), flight_->machine(), 0, folder.text(), 10);
    for (const char* name :
         {"colour_000010.png", "intensity_000010.exr", "rank_000010.exr", "list_000010.exr",
          "object_000010.exr", "face_000010.exr", "edges_000010.png", "flat_000010.png"})
        EXPECT_TRUE(std::filesystem::exists(folder.file(name))) << name;
    const auto input = OIIO::ImageInput::open(folder.file("face_000010.exr"));
    ASSERT_TRUE(input);
    std::vector<std::uint32_t> read(160U * 120U);
    ASSERT_TRUE(input->read_image(0, 0, 0, 1, OIIO::TypeDesc::UINT32, read.data()));
    EXPECT_EQ(read, plane(ig::Plane::face));
}

} // namespace
} // namespace linkdig::tools
