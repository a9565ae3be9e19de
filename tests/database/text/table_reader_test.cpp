#include "database/text/table_reader.h"

#include "database/model/mathematics.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

namespace linkdig::database {
namespace {

using testing::HasSubstr;

/// What the reader says when `read` reads the text's table.
std::string said(const char* text, const std::function<void(TableReader&)>& read) {
    const toml::table table = toml::parse(text);
    Diagnostics diagnostics;
    TableReader reader(table, "f", "[thing]", diagnostics);
    read(reader);
    return diagnostics.text();
}

TEST(TableReader, ReadsWhatStandsThere) {
    const std::string text =
        said("t = \"x\"\nn = 2\nr = 2.5\nb = true\nc = \"two\"\na_ft = 10\ns_kt = 10\nw_deg = 90\n"
             "d_s = 3\np_ft = [1, 2, 3]\nl = [\"u\", \"v\"]\nq_m = [[1, 2], [3, 4]]\nv = [0, 0, 1]",
             [](TableReader& r) {
                 EXPECT_EQ(r.text("t"), "x");
                 EXPECT_EQ(r.integer("n", 0, 9), 2);
                 EXPECT_EQ(r.number("r"), 2.5);
                 EXPECT_TRUE(r.boolean("b", false));
                 EXPECT_EQ(r.choice("c", 0, {"one", "two"}), 1U);
                 EXPECT_DOUBLE_EQ(r.length_m("a"), 3.048);
                 EXPECT_DOUBLE_EQ(r.speed_mps("s"), 18520.0 / 3600.0);
                 EXPECT_DOUBLE_EQ(r.angle_rad("w"), pi / 2);
                 EXPECT_EQ(r.duration_s("d"), 3.0);
                 EXPECT_NEAR(r.point_m("p").z, 0.9144, 1e-12);
                 EXPECT_EQ(r.texts("l"), (std::vector<std::string>{"u", "v"}));
                 EXPECT_EQ(r.points2_m("q")[1], Vec2d(3, 4));
                 EXPECT_EQ(r.vector("v"), Vec3d(0, 0, 1));
                 EXPECT_EQ(r.number("absent", 7.0, {}), 7.0);
                 EXPECT_EQ(r.angle_rad("absent", 180.0), pi);
                 EXPECT_EQ(r.table("absent"), nullptr);
                 EXPECT_TRUE(r.tables("absent").empty());
                 r.finish();
             });
    EXPECT_EQ(text, "");
}

TEST(TableReader, TellsOfMissingKeysWhereTheTableStands) {
    const auto read = [](TableReader& r) {
        r.text("name");
        r.length_m("radius");
    };
    EXPECT_EQ(said("", read), "f:1:1: error: [thing] lacks the key \"name\"\n"
                              "f:1:1: error: [thing] lacks the key \"radius_m\" or \"radius_ft\"\n");
}

TEST(TableReader, TellsOfUnknownKeysWithTheClosestKnownOne) {
    const auto read = [](TableReader& r) {
        r.text("colour", "");
        r.finish();
    };
    EXPECT_EQ(said("\n  color = 1", read),
              "f:2:3: error: unknown key \"color\" in [thing]; did you mean \"colour\"?\n");
    EXPECT_THAT(said("zzz = 1", read), HasSubstr("expected one of: colour"));
}

TEST(TableReader, TellsOfWrongTypes) {
    EXPECT_THAT(said("a = 1", [](TableReader& r) { r.text("a"); }),
                HasSubstr("f:1:5: error: \"a\" is a whole number; expected a text"));
    EXPECT_THAT(said("a = \"\"", [](TableReader& r) { r.text("a"); }), HasSubstr("empty text"));
    EXPECT_THAT(said("a = \"1\"", [](TableReader& r) { r.number("a"); }),
                HasSubstr("\"a\" is a text; expected a finite number"));
    EXPECT_THAT(said("a = 1.5", [](TableReader& r) { r.integer("a", 0, 9); }),
                HasSubstr("\"a\" is a number; expected a whole number"));
    EXPECT_THAT(said("a = 1", [](TableReader& r) { r.boolean("a", true); }),
                HasSubstr("expected true or false"));
    EXPECT_THAT(said("a = [1, 2]", [](TableReader& r) { r.vector("a"); }), HasSubstr("expected [x, y, z]"));
    EXPECT_THAT(said("a = 1979-05-27", [](TableReader& r) { r.table("a"); }),
                HasSubstr("is a date or time; expected a table"));
    EXPECT_THAT(said("a = [1]", [](TableReader& r) { r.tables("a"); }), HasSubstr("expected a table"));
    EXPECT_THAT(said("a = [1]", [](TableReader& r) { r.texts("a"); }), HasSubstr("expected a text"));
    EXPECT_THAT(said("a = \"x\"",
                     [](TableReader& r) {
                         r.choice("a", 0, {"u", "v"});
                     }),
                HasSubstr("expected one of \"u\", \"v\""));
}

TEST(TableReader, TellsOfNumbersThatAreNone) {
    EXPECT_THAT(said("a = nan", [](TableReader& r) { r.number("a"); }), HasSubstr("\"a\" is not a number"));
    EXPECT_THAT(said("a_m = -inf", [](TableReader& r) { r.length_m("a"); }),
                HasSubstr("\"a_m\" is infinite"));
    EXPECT_THAT(said("a_m = [0, nan, 0]", [](TableReader& r) { r.point_m("a"); }),
                HasSubstr("three finite numbers"));
}

TEST(TableReader, TellsOfRangesInTheUnitThatIsWritten) {
    const auto read = [](TableReader& r) { r.length_m("a", {}, {0.3048, 3.048}); };
    EXPECT_THAT(said("a_ft = 11", read), HasSubstr("\"a_ft\" is 11; expected 1 to 10"));
    EXPECT_EQ(said("a_ft = 10", read), "");
    EXPECT_THAT(said("a = -1", [](TableReader& r) { EXPECT_EQ(r.integer("a", 0, 9), 0); }),
                HasSubstr("\"a\" is -1; expected 0 to 9"));
    EXPECT_THAT(said("a = -1", [](TableReader& r) { r.number("a", {0.0}); }),
                HasSubstr("expected at least 0"));
}

TEST(TableReader, WantsOneUnitOnly) {
    EXPECT_THAT(said("a_m = 1\na_ft = 1", [](TableReader& r) { r.length_m("a"); }),
                HasSubstr("f:2:8: error: both \"a_m\" and \"a_ft\" stand in [thing]"));
}

} // namespace
} // namespace linkdig::database
