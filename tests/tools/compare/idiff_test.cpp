// A second opinion: OpenImageIO's own idiff, on seeded mutations of frames.

#include "tests/tools/compare/frames.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace linkdig::tools {
namespace {

enum class Mutation { none, pixel, shifted, brightness, noise, cropped, depth, depth_and_pixel, count };

Frame mutated(const Frame& from, Mutation mutation, std::mt19937& random) {
    Frame to = from;
    const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
    switch (mutation) {
    case Mutation::pixel:
    case Mutation::depth_and_pixel:
        to.at(below(to.width), below(to.height), below(3)) ^= static_cast<std::uint8_t>(1U << random() % 8U);
        break;
    case Mutation::shifted:
        std::rotate(to.samples.begin(), to.samples.begin() + 3 * (1 + below(20)), to.samples.end());
        break;
    case Mutation::brightness:
        for (std::uint8_t& sample : to.samples)
            sample = static_cast<std::uint8_t>(sample + 1);
        break;
    case Mutation::noise:
        for (int k = 0; k < 50; ++k)
            to.at(below(to.width), below(to.height), below(3)) = static_cast<std::uint8_t>(random());
        break;
    case Mutation::cropped:
        to.height -= 1 + below(5);
        to.samples.resize(static_cast<std::size_t>(to.width * to.height * 3));
        break;
    default:
        break;
    }
    return to;
}

/// 0: idiff finds the two the same.
int idiff(const std::string& a, const std::string& b) {
    const std::string command = fmt::format("idiff '{}' '{}' >/dev/null 2>&1", a, b);
    return WEXITSTATUS(std::system(command.c_str()));
}

/// Two hundred mutations in four parts: starting idiff takes a while on a busy machine.
class CompareIdiff : public testing::TestWithParam<unsigned> {};

TEST_P(CompareIdiff, SameVerdictsOnFiftyMutations) {
    if (std::system("command -v idiff >/dev/null") != 0) GTEST_SKIP() << "no idiff (openimageio-tools)";
    const TemporaryFolder folder;
    std::filesystem::create_directories(folder.file("a"));
    std::filesystem::create_directories(folder.file("b"));
    std::mt19937 random(GetParam());
    constexpr int mutations = 50;
    for (int k = 0; k < mutations; ++k) {
        const auto mutation = static_cast<Mutation>(k % static_cast<int>(Mutation::count));
        const Frame frame = test_frame(48, 36, GetParam() + static_cast<unsigned>(k));
        const std::string name = fmt::format("/f{}.png", k);
        const bool deeper = mutation == Mutation::depth || mutation == Mutation::depth_and_pixel;
        write_frame(folder.file("a") + name, frame);
        write_frame(folder.file("b") + name, mutated(frame, mutation, random),
                    deeper ? OIIO::TypeDesc::UINT16 : OIIO::TypeDesc::UINT8);
    }
    const std::string junit = folder.file("junit.xml");
    run("compare '" + folder.file("a") + "' '" + folder.file("b") + "' --junit '" + junit + "'");
    const std::string xml = bytes_of(junit);
    int same = 0;
    for (int k = 0; k < mutations; ++k) {
        const std::string name = fmt::format("f{}.png", k);
        const bool ours = xml.find("name=\"" + name + "\"/>") != std::string::npos;
        EXPECT_EQ(ours, idiff(folder.file("a/" + name), folder.file("b/" + name)) == 0) << name;
        same += ours ? 1 : 0;
    }
    EXPECT_GE(same, 10); // unchanged frames, and frames at another depth
    EXPECT_LE(same, 15);
}

INSTANTIATE_TEST_SUITE_P(Seeds, CompareIdiff, testing::Values(1979U, 1980U, 1981U, 1982U));

} // namespace
} // namespace linkdig::tools
