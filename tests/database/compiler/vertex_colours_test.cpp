/// Colours of vertices: by name or by numbers, kept where faces are cut.

#include "tests/database/compiler/authored.h"

#include "database/format/validate.h"

#include <gmock/gmock.h>

namespace linkdig::database {
namespace {

using testing::HasSubstr;

const std::string quad = "[[object]]\nname = \"o\"\nlist = \"list\"\ncolour = \"grey\"\n"
                         "vertices_m = { a = [0, 0, 0], b = [10, 0, 0], c = [10, 10, 0], d = [0, 10, 0] }\n";
const std::string face = "[[object.face]]\ncorners = [\"a\", \"b\", \"c\", \"d\"]\n";

Colour colour_at(const VisualDatabase& d, const Face& of, const Vec3f& position) {
    for (std::uint32_t k = 0; k < of.corner_count; ++k)
        if (Vec3f(d.vertices[d.corners[of.first_corner + k]].position) == position)
            return d.corner_colours[of.first_corner + k];
    ADD_FAILURE() << "no corner there";
    return {};
}

TEST(VertexColours, AreNamedOrNumbersAndTheFacesOwnElsewhere) {
    const CompileResult result =
        compile_text(scene(quad + "colours = { a = [1, 2, 3], c = \"grey\" }\n" + face));
    ASSERT_TRUE(result.database) << messages(result);
    const VisualDatabase& d = *result.database;
    EXPECT_EQ(validate(d), "");
    ASSERT_EQ(d.faces.size(), 1U);
    EXPECT_EQ(d.faces[0].coloured, 1);
    EXPECT_EQ(colour_at(d, d.faces[0], {0, 0, 0}), (Colour{1, 2, 3, 0}));
    EXPECT_EQ(colour_at(d, d.faces[0], {10, 10, 0}), (Colour{128, 128, 128, 0}));
    EXPECT_EQ(colour_at(d, d.faces[0], {10, 0, 0}), (Colour{128, 128, 128, 0}));
}

TEST(VertexColours, OfADatabaseWithoutAnyTakeNoRoom) {
    const CompileResult result = compile_text(scene(quad + face));
    ASSERT_TRUE(result.database) << messages(result);
    EXPECT_EQ(result.database->faces[0].coloured, 0);
    EXPECT_TRUE(result.database->corner_colours.empty());
}

/// Walls through each other are cut; the new corners lie on the colour's way from end to end.
TEST(VertexColours, AreInterpolatedWhereAFaceIsCut) {
    const std::string wall =
        "[[object]]\nname = \"w\"\nlist = \"list\"\ncolour = \"grey\"\ntwo_sided = true\n"
        "vertices_m = { a = [4, -5, -5], b = [4, 15, -5], c = [4, 15, 5], d = [4, -5, 5] }\n";
    const CompileResult result = compile_text(
        scene(wall + face + quad + // the first one's plane cuts the other
              "two_sided = true\n"
              "colours = { a = [0, 0, 0], b = [200, 0, 0], c = [200, 0, 100], d = [0, 0, 100] }\n" +
              face));
    ASSERT_TRUE(result.database) << messages(result);
    const VisualDatabase& d = *result.database;
    EXPECT_GT(result.statistics.total().splits, 0U);
    int cut = 0;
    for (const Face& each : d.faces) {
        if (each.coloured == 0) continue;
        for (std::uint32_t k = 0; k < each.corner_count; ++k) {
            const Vec4f& p = d.vertices[d.corners[each.first_corner + k]].position;
            const Colour& colour = d.corner_colours[each.first_corner + k];
            EXPECT_NEAR(colour.red, 20 * p.x, 0.51);
            EXPECT_NEAR(colour.blue, 10 * p.y, 0.51);
            cut += p.x > 1 && p.x < 9 ? 1 : 0;
        }
    }
    EXPECT_GE(cut, 1);
}

TEST(VertexColours, MistakesAreTold) {
    const auto said = [](const std::string& colours) {
        const CompileResult result = compile_text(scene(quad + colours + face));
        EXPECT_FALSE(result.database) << colours;
        return messages(result);
    };
    EXPECT_THAT(said("colours = { e = \"grey\" }\n"),
                HasSubstr("root.toml:20: [[object]] \"o\" has no vertex \"e\""));
    EXPECT_THAT(said("colours = { a = \"gray\" }\n"), HasSubstr("no colour is named \"gray\"; did you mean"));
    EXPECT_THAT(said("colours = { a = [1, 2] }\n"), HasSubstr("root.toml:20: "));
    EXPECT_THAT(said("colours = { a = [1, 2, 256] }\n"),
                HasSubstr("root.toml:20: \"a\" holds 256; expected whole numbers 0 to 255"));
    EXPECT_THAT(said("colours = { a = 7 }\n"), HasSubstr("root.toml:20: "));
    EXPECT_THAT(said("colours = \"grey\"\n"), HasSubstr("root.toml:20: "));
}

} // namespace
} // namespace linkdig::database
