/// The author's tools: what is watched, and what a preview shows.

#include "database/compiler/compile.h"
#include "ig/machine/machine.h"
#include "tests/tools/pictures.h"
#include "tools/preview/preview.h"
#include "tools/watch/file_watch.h"

#include <gmock/gmock.h>

#include <fstream>

namespace linkdig::tools {
namespace {

void write(const std::string& path, const std::string& text) { std::ofstream(path) << text; }

TEST(FileWatch, SeesWhatIsWrittenReplacedRemovedAndMade) {
    const TemporaryFolder folder;
    const std::string a = folder.file("a"), b = folder.file("b");
    write(a, "1");
    FileWatch watch;
    watch.set({a, b});
    EXPECT_FALSE(watch.changed());
    write(a, "12");
    EXPECT_TRUE(watch.changed());
    EXPECT_FALSE(watch.changed());
    write(b, "made");
    EXPECT_TRUE(watch.changed());
    write(folder.file("c"), "12"); // as many bytes, renamed over it
    std::filesystem::rename(folder.file("c"), a);
    EXPECT_TRUE(watch.changed());
    std::filesystem::remove(b);
    EXPECT_TRUE(watch.changed());
    EXPECT_FALSE(watch.changed());
}

TEST(FileWatch, AChangeBetweenTwoListsIsNotLost) {
    const TemporaryFolder folder;
    const std::string a = folder.file("a"), b = folder.file("b");
    write(a, "1");
    FileWatch watch;
    watch.set({a});
    write(a, "12");
    watch.set({a, b});
    EXPECT_TRUE(watch.changed());
    watch.set({b});
    write(a, "123");
    EXPECT_FALSE(watch.changed());
}

const std::string shipped = LINKDIG_SOURCE_DIR "/database/scenes/first_flight/first_flight.toml";

TEST(Preview, ShowsTheShipTheSeaAndNotTheSky) {
    const database::CompileResult compiled = database::compile_file(shipped);
    ASSERT_TRUE(compiled.database);
    std::vector<std::string> names;
    for (const PreviewSubject& subject : preview_subjects(*compiled.database))
        names.push_back(subject.name);
    EXPECT_THAT(names, testing::Contains("lph2"));
    EXPECT_THAT(names, testing::Contains("sea"));
    EXPECT_THAT(names, testing::Not(testing::Contains("sky")));
}

/// A pier stands at the origin, where a ship would stand; the sea behind both is no subject of its own there.
TEST(Preview, AShipStandsClearOfWhatIsStatic) {
    const database::CompileResult compiled =
        database::compile_file(LINKDIG_SOURCE_DIR "/database/scenes/pier/pier.toml");
    ASSERT_TRUE(compiled.database);
    const std::vector<PreviewSubject> subjects = preview_subjects(*compiled.database);
    const PreviewSubject& ship = subjects.front();
    ASSERT_NE(ship.moving_object, none);
    const FramePacket packet = preview_packet(*compiled.database, ship, preview_view(0), 1.5);
    const double west_end =
        packet.moving_objects.at(static_cast<std::size_t>(ship.moving_object)).position_m.x -
        glm::length(ship.half_extent_m);
    int solid = 0;
    for (const PreviewSubject& subject : subjects) {
        EXPECT_NE(subject.name, "sea");
        if (subject.moving_object != none) continue;
        ++solid;
        EXPECT_LT(subject.centre_m.x + subject.half_extent_m.x, west_end) << subject.name;
    }
    EXPECT_GE(solid, 2);
}

/// Every view holds the whole subject: its border is sky all round, its middle is not.
TEST(Preview, TheSubjectFillsTheMiddleAndLeavesTheBorder) {
    const database::CompileResult compiled = database::compile_file(shipped);
    ASSERT_TRUE(compiled.database);
    const VisualDatabase& database = *compiled.database;
    ig::Configuration configuration = ig::modern_profile();
    configuration.raster = {.width = 160, .height = 120};
    configuration.threads = 1;
    ig::Machine machine(database, configuration);
    machine.draw_planes(false, true);
    const PreviewSubject ship = preview_subjects(database).front();
    ASSERT_NE(ship.moving_object, none);
    for (std::uint32_t v = 0; v < preview_views; ++v) {
        const FramePacket packet = preview_packet(database, ship, preview_view(v), 160.0 / 120.0);
        ASSERT_TRUE(machine.frame(packet).errors.empty());
        const ig::VideoFrame& picture = machine.picture(0);
        const auto of_ship = [&](std::uint32_t x, std::uint32_t y) {
            const auto source = machine.source(0, picture.rank[std::size_t{y} * picture.width + x]);
            return source.face != nullptr &&
                   database.clusters[database.lists[source.list].cluster].moving_object == ship.moving_object;
        };
        int inside = 0, on_border = 0;
        for (std::uint32_t y = 0; y < picture.height; ++y)
            for (std::uint32_t x = 0; x < picture.width; ++x) {
                const bool border = x == 0 || y == 0 || x + 1 == picture.width || y + 1 == picture.height;
                (border ? on_border : inside) += of_ship(x, y) ? 1 : 0;
            }
        EXPECT_EQ(on_border, 0) << preview_view(v).name;
        EXPECT_GT(inside, 600) << preview_view(v).name;
    }
}

} // namespace
} // namespace linkdig::tools
