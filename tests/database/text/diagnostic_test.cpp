#include "database/text/diagnostic.h"

#include <gtest/gtest.h>

namespace linkdig::database {
namespace {

TEST(Diagnostics, AreToldInTheOrderOfFileLineAndColumn) {
    Diagnostics diagnostics;
    EXPECT_FALSE(diagnostics.any());
    EXPECT_EQ(diagnostics.text(), "");
    diagnostics.error({"b.toml", 1, 1}, "third");
    diagnostics.error({"a.toml", 10, 2}, "second");
    diagnostics.error({"a.toml", 9, 30}, "first");
    diagnostics.error({"b.toml", 1, 1}, "fourth");
    EXPECT_TRUE(diagnostics.any());
    EXPECT_EQ(diagnostics.text(), "a.toml:9:30: error: first\n"
                                  "a.toml:10:2: error: second\n"
                                  "b.toml:1:1: error: third\n"
                                  "b.toml:1:1: error: fourth\n");
}

TEST(Suggestion, IsTheClosestSpellingAndNothingWhenNoneIsClose) {
    const std::vector<std::string> words{"colour", "corners", "shading", "a"};
    EXPECT_EQ(suggestion("color", words), "\"colour\"");
    EXPECT_EQ(suggestion("coluor", words), "\"colour\"");
    EXPECT_EQ(suggestion("shadnig", words), "\"shading\"");
    EXPECT_EQ(suggestion("zzzzzz", words), "");
    EXPECT_EQ(suggestion("", {}), "");
    EXPECT_EQ(suggestion(std::string(5000, 'x'), words), "");
}

} // namespace
} // namespace linkdig::database
