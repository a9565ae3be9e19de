#include "tests/tools/pictures.h"
#include "tools/film/film.h"

#include <gmock/gmock.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <utility>

namespace linkdig::tools {
namespace {

void shoot(const std::string& path, std::uint32_t width, std::uint32_t height, std::uint32_t frames) {
    Film film(path, width, height, 30);
    for (std::uint32_t frame = 0; frame < frames; ++frame)
        film.add(test_picture(width, height, frame));
    film.finish();
}

/// What ffprobe, which knows nothing of us, finds in the film; empty where there is no ffprobe.
std::string probe(const std::string& path) {
    const std::string command = "ffprobe -v error -count_frames -select_streams v:0 -show_entries "
                                "stream=width,height,nb_read_frames,r_frame_rate -of csv=p=0 '" +
                                path + "' 2>/dev/null";
    std::string text;
    FILE* pipe = popen(command.c_str(), "r");
    std::array<char, 256> buffer{};
    while (pipe != nullptr && std::fgets(buffer.data(), buffer.size(), pipe) != nullptr)
        text += buffer.data();
    if (pipe != nullptr) pclose(pipe);
    return text;
}

class FilmTest : public testing::Test {
protected:
    void SetUp() override {
        if (!video_files()) GTEST_SKIP() << "built without video files";
    }
    TemporaryFolder folder_;
};

TEST_F(FilmTest, TwoFilmsOfTheSamePicturesAreTheSameBytes) {
    // Small pictures, several times in one process: what an encoder reads beyond its rows is then never the
    // same.
    for (const auto& [width, height] : {std::pair{64U, 48U}, {34U, 30U}, {200U, 150U}}) {
        shoot(folder_.file("first.mp4"), width, height, 40);
        const std::string bytes = bytes_of(folder_.file("first.mp4"));
        EXPECT_GT(bytes.size(), 1000U);
        for (int again = 0; again < 3; ++again) {
            shoot(folder_.file("again.mp4"), width, height, 40);
            EXPECT_TRUE(bytes == bytes_of(folder_.file("again.mp4"))) << width << " x " << height;
        }
    }
}

TEST_F(FilmTest, OtherPicturesMakeAnotherFilm) {
    shoot(folder_.file("a.mp4"), 64, 48, 3);
    shoot(folder_.file("b.mp4"), 64, 48, 4);
    EXPECT_NE(bytes_of(folder_.file("a.mp4")), bytes_of(folder_.file("b.mp4")));
}

TEST_F(FilmTest, EveryFrameIsInTheFilm) {
    shoot(folder_.file("a.mp4"), 64, 48, 31);
    const std::string found = probe(folder_.file("a.mp4"));
    if (found.empty()) GTEST_SKIP() << "no ffprobe";
    EXPECT_EQ(found, "64,48,30/1,31\n");
}

TEST_F(FilmTest, OddPicturesLoseTheirLastColumnAndRow) {
    shoot(folder_.file("a.mp4"), 65, 49, 2);
    const std::string found = probe(folder_.file("a.mp4"));
    if (found.empty()) GTEST_SKIP() << "no ffprobe";
    EXPECT_EQ(found, "64,48,30/1,2\n");
}

TEST_F(FilmTest, AFilmThatCannotBeWrittenIsNamed) {
    try {
        shoot("/nowhere/at/all/a.mp4", 64, 48, 1);
        FAIL() << "written into nowhere";
    } catch (const std::runtime_error& error) {
        EXPECT_THAT(error.what(),
                    testing::StartsWith("/nowhere/at/all/a.mp4: cannot be written: No such file"));
    }
}

TEST_F(FilmTest, ASinglePixelIsRefused) {
    EXPECT_THROW(shoot(folder_.file("a.mp4"), 1, 1, 1), std::runtime_error);
}

} // namespace
} // namespace linkdig::tools
