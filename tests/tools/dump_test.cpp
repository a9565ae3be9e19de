#include "tests/tools/pictures.h"
#include "tools/film/film.h"
#include "tools/flight/dump.h"

#include <gmock/gmock.h>

#include <map>

namespace linkdig::tools {
namespace {

DumpRequest request_into(const std::string& folder, std::uint64_t frames) {
    return {.folder = folder,
            .film_name = video_files() ? "approach" : "",
            .heading = "test",
            .frames = frames,
            .frames_per_second = 30,
            .width = 32,
            .height = 24,
            .progress = false};
}

/// Draws into one picture over and over, as the machine does.
void dump(const std::string& folder, std::uint64_t frames) {
    ig::VideoFrame picture;
    dump_flight(request_into(folder, frames), [&](std::uint64_t frame) -> const ig::VideoFrame& {
        picture = test_picture(32, 24, static_cast<std::uint32_t>(frame));
        return picture;
    });
}

std::map<std::string, std::string> contents(const std::string& folder) {
    std::map<std::string, std::string> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        files[entry.path().filename().string()] = bytes_of(entry.path());
    return files;
}

TEST(Dump, OneFilePerFrameAFilmAndASheet) {
    const TemporaryFolder folder;
    dump(folder.file("new/deep"), 40);
    const auto files = contents(folder.file("new/deep"));
    EXPECT_EQ(files.size(), video_files() ? 42U : 41U);
    EXPECT_TRUE(files.contains("frame_000000.png"));
    EXPECT_TRUE(files.contains("frame_000039.png"));
    EXPECT_TRUE(files.contains("contact.png"));
    for (int frame = 1; frame < 40; ++frame) {
        const auto name = [](int number) {
            return "frame_0000" + std::to_string(100 + number).substr(1) + ".png";
        };
        EXPECT_NE(files.at(name(frame)), files.at(name(frame - 1)));
    }
}

TEST(Dump, TwoRunsGiveTheSameBytes) {
    const TemporaryFolder folder;
    dump(folder.file("a"), 30);
    dump(folder.file("b"), 30);
    EXPECT_EQ(contents(folder.file("a")), contents(folder.file("b")));
}

TEST(Dump, FramesAreDrawnOnceInOrder) {
    const TemporaryFolder folder;
    std::vector<std::uint64_t> drawn;
    const ig::VideoFrame picture = test_picture(32, 24);
    dump_flight(request_into(folder.text(), 5), [&](std::uint64_t frame) -> const ig::VideoFrame& {
        drawn.push_back(frame);
        return picture;
    });
    EXPECT_THAT(drawn, testing::ElementsAre(0, 1, 2, 3, 4));
}

TEST(Dump, AFolderThatCannotBeMadeIsNamed) {
    const TemporaryFolder folder;
    std::ofstream(folder.file("file")) << "in the way";
    try {
        dump(folder.file("file/below"), 1);
        FAIL() << "made a folder below a file";
    } catch (const std::runtime_error& error) {
        EXPECT_THAT(error.what(), testing::StartsWith(folder.file("file/below") + ": cannot be made"));
    }
}

TEST(Dump, AMistakeWhileDrawingReachesTheCaller) {
    const TemporaryFolder folder;
    EXPECT_THROW(
        dump_flight(request_into(folder.text(), 3),
                    [](std::uint64_t) -> const ig::VideoFrame& { throw std::runtime_error("refused"); }),
        std::runtime_error);
}

} // namespace
} // namespace linkdig::tools
