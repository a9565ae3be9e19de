#include "database/text/table_reader.h"
#include "tests/database/compiler/authored.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace linkdig::database {
namespace {

using testing::EndsWith;
using testing::HasSubstr;

std::string refusal(const std::string& path) {
    Diagnostics diagnostics;
    EXPECT_FALSE(parse_file(path, diagnostics));
    return diagnostics.text();
}

TEST(ParseFile, RefusesWhatIsNoTextFile) {
    const ScratchFolder folder;
    EXPECT_THAT(refusal(folder.path() + "/absent.toml"), HasSubstr("absent.toml:0:0: error: no such file"));
    EXPECT_THAT(refusal(folder.path()), HasSubstr("is a directory"));
    EXPECT_THAT(refusal(folder.write("b.igdb", std::string("a = 1\n\0\1\2", 9))),
                HasSubstr("byte 6 is zero"));
    EXPECT_THAT(refusal(folder.write("latin.toml", "name = \"\xff\xfe\"\n")), HasSubstr("latin.toml:1:"));
    EXPECT_THAT(refusal("/dev/zero"), HasSubstr("is not a regular file"));
}

TEST(ParseFile, TellsWhereTheSyntaxBreaks) {
    const ScratchFolder folder;
    EXPECT_THAT(refusal(folder.write("a.toml", "a = 1\nb = \n")), HasSubstr("a.toml:2:"));
    EXPECT_THAT(refusal(folder.write("b.toml", "a = 1\na = 2\n")), HasSubstr("b.toml:2:"));
    EXPECT_THAT(refusal(folder.write("c.toml", "a = [1, \n")), EndsWith("expected TOML\n"));
    EXPECT_THAT(refusal(folder.write("d.toml", "a = " + std::string(100000, '['))), HasSubstr("d.toml:1:"));
}

TEST(ParseFile, TakesAnEmptyFileAsAnEmptyTable) {
    const ScratchFolder folder;
    Diagnostics diagnostics;
    const auto document = parse_file(folder.write("empty.toml", ""), diagnostics);
    ASSERT_TRUE(document);
    EXPECT_TRUE(document->root.empty());
    EXPECT_FALSE(diagnostics.any());
}

} // namespace
} // namespace linkdig::database
