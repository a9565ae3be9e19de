/// Edges counted, and held to what the author allows.

#include "tests/database/compiler/authored.h"

#include "database/model/edge_count.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

namespace linkdig::database {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::string box_object(const std::string& name, double x, const std::string& more = "") {
    return fmt::format(
        "[[object]]\nname = \"{}\"\nlist = \"list\"\ncolour = \"grey\"\n{}[[object.box]]\nfrom_m = [{}, 0, "
        "0]\nto_m = [{}, 1, 1]\n",
        name, more, x, x + 1);
}

TEST(EdgeCount, ABoxHasTwelveHoweverManyNormalsAtItsCorners) {
    for (const char* shading : {"face", "vertex"}) {
        const CompileResult result = compile_text(
            scene(box_object("a", 0, fmt::format("shading = \"{}\"\n", shading)) + box_object("b", 5)));
        ASSERT_TRUE(result.database) << messages(result);
        const EdgeCounts counts = count_edges(*result.database);
        EXPECT_THAT(counts.objects, ElementsAre(12U, 12U));
        EXPECT_THAT(counts.lists, ElementsAre(24U));
        EXPECT_THAT(counts.lists_at_most, ElementsAre(24U));
    }
}

TEST(EdgeCount, ObjectsThatTouchShareEdgesInTheirList) {
    // Two boxes side by side: the four edges of the square between them are the same.
    const CompileResult result = compile_text(scene(box_object("a", 0) + box_object("b", 1)));
    ASSERT_TRUE(result.database) << messages(result);
    EXPECT_THAT(count_edges(*result.database).lists, ElementsAre(20U));
    EXPECT_THAT(count_edges(*result.database).lists_at_most, ElementsAre(20U)); // never more than there are
}

TEST(EdgeCount, AlternativesCountOnce) {
    const CompileResult result = compile_text(
        scene("[[slot]]\nname = \"s\"\nalternatives = 2\n" + box_object("always", 9) +
              box_object("a", 0, "slot = \"s\"\nalternative = 0\n") +
              "[[object]]\nname = \"b\"\nlist = \"list\"\ncolour = \"grey\"\nslot = \"s\"\nalternative = 1\n"
              "[[object.rectangle]]\ncentre_m = [0, 0, 0]\nsize_m = [1, 1]\n"));
    ASSERT_TRUE(result.database) << messages(result);
    EXPECT_THAT(count_edges(*result.database).lists_at_most, ElementsAre(24U));
    EXPECT_EQ(result.statistics.total().edges_at_once, 24U);
}

TEST(EdgeBudget, MoreThanItIsAnError) {
    const auto with = [](int database, int list) {
        std::string text = scene(box_object("a", 0));
        const auto put = [&](const std::string& after, int budget) {
            text.insert(text.find(after) + after.size(), fmt::format("edge_budget = {}\n", budget));
        };
        if (database > 0) put("[database]\n", database);
        if (list > 0) put("[[object_list]]\n", list);
        return compile_text(text);
    };
    EXPECT_TRUE(with(12, 12).database);
    EXPECT_EQ(with(0, 12).statistics.lists[0].edge_budget, 12U);
    EXPECT_FALSE(with(0, 11).database);
    EXPECT_THAT(messages(with(0, 11)),
                HasSubstr("root.toml:11: object list \"list\" has up to 12 edges at once; expected "
                          "at most its edge_budget, 11"));
    EXPECT_THAT(messages(with(11, 0)), HasSubstr("root.toml:1: the database has up to 12 edges at once"));
    EXPECT_THAT(messages(with(11, 11)),
                testing::AllOf(HasSubstr("object list"), HasSubstr("the database has")));
}

TEST(EdgeBudget, IsAWholeNumberAboveNothing) {
    std::string text = scene(box_object("a", 0));
    text.insert(text.find("[database]\n") + 11, "edge_budget = 0\n");
    EXPECT_THAT(messages(compile_text(text)), HasSubstr("\"edge_budget\" is 0; expected 1 to 1000000000"));
}

TEST(Messages, AFaceWhoseNormalsPointBehindItIsReversed) {
    const auto square = [](const char* normals, const char* more) {
        return compile_text(scene(fmt::format(
            "[[object]]\nname = \"o\"\nlist = \"list\"\ncolour = \"grey\"\nshading = "
            "\"vertex\"\n{}vertices_m = {{ a = [0, 0, "
            "0], b = [4, 0, 0], c = [0, 4, 0] }}\nnormals = {}\n[[object.face]]\ncorners = ['a', 'b', 'c']\n",
            more, normals)));
    };
    EXPECT_THAT(messages(square("{ a = [0, 0, -1], b = [0.1, 0, -1], c = [0, 0.1, -1] }", "")),
                HasSubstr("a face of object \"o\" is reversed"));
    EXPECT_TRUE(square("{ a = [0, 0, 1], b = [0.1, 0, -1] }", "").database); // they do not agree
    EXPECT_TRUE(square("{ a = [0, 0, -1] }", "two_sided = true\n").database);
}

} // namespace
} // namespace linkdig::database
