#include "tools/flight/arguments.h"
#include "tools/flight/number_options.h"
#include "tools/flight/planes.h"

#include <gmock/gmock.h>

#include <stdexcept>

namespace linkdig::tools {
namespace {

template <class Call>
std::string complaint(const Call& call) {
    try {
        call();
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "";
}

TEST(Arguments, Sizes) {
    EXPECT_EQ(parse_size("1280x720").width, 1280U);
    EXPECT_EQ(parse_size("1280x720").height, 720U);
    EXPECT_EQ(parse_size("4096x16").width, 4096U);
    for (const char* wrong : {"", "x", "1280", "1280x", "x720", "1280x720 ", "1280x720x3", "-1x20", "15x100",
                              "100x4097", "1e3x100", "99999999999x16"})
        EXPECT_EQ(complaint([&] { parse_size(wrong); }),
                  std::string("'") + wrong +
                      "' is no picture size; expected WIDTHxHEIGHT, 16 to 4096 pixels each");
}

TEST(Arguments, Frames) {
    EXPECT_EQ(parse_frames("10:20").first, 10U);
    EXPECT_EQ(parse_frames("10:20").last, 20U);
    EXPECT_EQ(parse_frames("7").first, 7U);
    EXPECT_EQ(parse_frames("7").last, 7U);
    EXPECT_EQ(parse_frames("0:0").last, 0U);
    for (const char* wrong : {"", ":", "1:", ":2", "2:1", "a:b", "1:2:3", "-1:2", "1.5"})
        EXPECT_THAT(complaint([&] { parse_frames(wrong); }),
                    testing::HasSubstr("is no range of frames; expected"))
            << wrong;
}

/// The value that an option would take, or what is wrong with it.
std::string taken(const CLI::Validator& validator, std::string text) {
    const std::string wrong = validator(text);
    return wrong.empty() ? text : wrong;
}

TEST(Arguments, WholeNumbersAreDecimalAndWithoutASign) {
    EXPECT_EQ(taken(whole_number(), "0"), "0");
    EXPECT_EQ(taken(whole_number(), "18446744073709551615"), "18446744073709551615");
    EXPECT_EQ(taken(whole_number(), "000560"), "560"); // as in frame_000560.png, and not octal
    EXPECT_EQ(taken(whole_number(1, 8), "8"), "8");
    for (const char* wrong : {"", "-1", "+1", "18446744073709551616", "1.5", "1e3", "0x10", "1 ", "nan"})
        EXPECT_EQ(taken(whole_number(), wrong),
                  std::string("'") + wrong +
                      "' cannot be taken; expected a whole number, 0 to 18446744073709551615");
    for (const char* wrong : {"0", "9"})
        EXPECT_EQ(taken(whole_number(1, 8), wrong),
                  std::string("'") + wrong + "' cannot be taken; expected a whole number, 1 to 8");
}

TEST(Arguments, NumbersAreFinite) {
    for (const char* right : {"0.5", "1e1", "60", "0"})
        EXPECT_EQ(taken(finite_number(0.0, 60.0), right), right);
    for (const char* wrong : {"", "nan", "-nan", "inf", "-inf", "-0.1", "60.1", "1,5", "a"})
        EXPECT_EQ(taken(finite_number(0.0, 60.0), wrong),
                  std::string("'") + wrong + "' cannot be taken; expected a number, 0 to 60");
}

TEST(Arguments, Planes) {
    EXPECT_THAT(parse_planes("colour,face,rank"),
                testing::ElementsAre(ig::Plane::colour, ig::Plane::face, ig::Plane::rank));
    EXPECT_THAT(parse_planes("object"), testing::ElementsAre(ig::Plane::object));
    EXPECT_EQ(
        complaint([] { parse_planes("colour,depth"); }),
        "there is no plane named 'depth'; expected some of colour, intensity, rank, list, object, face, "
        "edges, flat");
    for (const char* wrong : {"", ",", "colour,", ",colour", "colour, rank", "Colour"})
        EXPECT_NE(complaint([&] { parse_planes(wrong); }), "") << wrong;
    for (const ig::Plane plane : {ig::Plane::colour, ig::Plane::intensity, ig::Plane::rank, ig::Plane::list,
                                  ig::Plane::object, ig::Plane::face, ig::Plane::edges, ig::Plane::flat})
        EXPECT_THAT(parse_planes(plane_name(plane)), testing::ElementsAre(plane));
}

TEST(Planes, IntensitiesAreExactAndTheBackgroundIsBlack) {
    EXPECT_THAT(intensities(std::vector<std::int32_t>{-1, 0, 1, (1 << 22) - 1, 1 << 22}),
                testing::ElementsAre(0.0F, 0.0F, 1.0F / 4194304, 4194303.0F / 4194304, 1.0F));
}

} // namespace
} // namespace linkdig::tools
