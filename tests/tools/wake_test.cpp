#include "tests/tools/command.h"
#include "tools/subcommands.h"

#include <OpenImageIO/imageio.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>

namespace linkdig::tools {
namespace {

using testing::HasSubstr;

const std::string star = LINKDIG_SOURCE_DIR "/database/scenes/wakes/kelvin/figure22.toml";

TEST(Wake, WritesFieldAndGreyImage) {
    const TemporaryFolder folder;
    const std::string field = folder.file("star.exr");
    const Outcome outcome = run("wake " + star + " -o " + field + " --png --size 96 --json");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
    const nlohmann::json told = nlohmann::json::parse(outcome.output);
    EXPECT_EQ(told["cells"], 96);
    EXPECT_EQ(told["swimmers"].size(), 5U);
    EXPECT_GT(told["rms"], 0.1);
    const auto file = OIIO::ImageInput::open(field);
    ASSERT_TRUE(file);
    EXPECT_EQ(file->spec().width, 96);
    EXPECT_EQ(file->spec().format, OIIO::TypeDesc::FLOAT);
    std::vector<float> heights(96U * 96U);
    ASSERT_TRUE(file->read_image(0, 0, 0, 1, OIIO::TypeDesc::FLOAT, heights.data()));
    // A boat swims up: its tip is the first row of the picture that is not still, in its middle.
    const auto first =
        std::ranges::find_if(heights, [](float h) { return std::abs(h) > 0.5F; }) - heights.begin();
    EXPECT_LT(first / 96, 10);
    EXPECT_NEAR(static_cast<double>(first % 96), 47.5, 3.0);
    EXPECT_TRUE(std::filesystem::exists(folder.file("star.png")));
    const Outcome again = run("wake " + star + " -o " + folder.file("b.exr") + " --size 96");
    EXPECT_EQ(bytes_of(field), bytes_of(folder.file("b.exr")));
    EXPECT_THAT(again.output, HasSubstr("million samples"));
}

TEST(Wake, MistakesAndPathsThatLeaveTheField) {
    const TemporaryFolder folder;
    EXPECT_EQ(run("wake " + star + " -o " + folder.file("a.png")).exit_code, 2);
    EXPECT_EQ(run("wake " + folder.file("none.toml") + " -o " + folder.file("a.exr")).exit_code, 2);
    const std::string spec = folder.file("spec.toml");
    std::ofstream(spec)
        << "[field]\ncells = 32\nside_m = 8.0\n[[swimmer]]\nname = \"boat\"\nspeed_mps = 0.0\n";
    const Outcome bad = run("wake " + spec + " -o " + folder.file("a.exr"));
    EXPECT_EQ(bad.exit_code, 2);
    EXPECT_THAT(bad.errors, HasSubstr(spec + ":6:13: error: "));
    EXPECT_FALSE(std::filesystem::exists(folder.file("a.exr")));
    std::ofstream(spec)
        << "[field]\ncells = 32\nside_m = 8.0\n[[swimmer]]\nname = \"boat\"\nspeed_mps = 1.0\n"
           "[[swimmer.path]]\nkind = \"line\"\npoints_m = [[1.0, 4.0], [14.0, 4.0]]\n";
    const Outcome outside = run("wake " + spec + " -o " + folder.file("a.exr"));
    EXPECT_EQ(outside.exit_code, 0);
    EXPECT_THAT(outside.errors, HasSubstr("% of the wake of \"boat\" lies beyond the field and is left out"));
    std::ofstream(spec)
        << "[field]\ncells = 32\nside_m = 8.0\n[[swimmer]]\nname = \"boat\"\nspeed_mps = 1.0\n"
           "[[swimmer.path]]\nkind = \"line\"\npoints_m = [[100.0, 4.0], [114.0, 4.0]]\n";
    EXPECT_THAT(run("wake " + spec + " -o " + folder.file("a.exr")).errors,
                HasSubstr("100.00 % of the wake of \"boat\" lies beyond the field and is left out"));
    std::ofstream(spec)
        << "[field]\ncells = 32\nside_m = 8.0\n[[swimmer]]\nname = \"boat\"\nspeed_mps = 0.5\n"
           "[[swimmer.path]]\nkind = \"line\"\npoints_m = [[1.0, 4.0], [7.0, 4.0]]\n";
    EXPECT_THAT(
        run("wake " + spec + " -o " + folder.file("a.exr")).errors,
        HasSubstr("the longest waves of \"boat\" are 0.64 cells long; waves under two cells are left out"));
    EXPECT_EQ(run("wake " + star + " --size 64 -o /nowhere/a.exr").exit_code, 3);
}

} // namespace
} // namespace linkdig::tools
