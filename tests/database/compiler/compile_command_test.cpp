/// linkdig compile as a shell sees it: exit codes, and nothing written when the author made a mistake.

#ifdef LINKDIG_BINARY

#include "tests/database/compiler/authored.h"

#include <gmock/gmock.h>
#include <sys/wait.h>

#include <cstdlib>
#include <iterator>

namespace linkdig::database {
namespace {

using testing::HasSubstr;

int run(const std::string& arguments) {
    const int status = std::system(("'" LINKDIG_BINARY "' compile " + arguments).c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

std::string bytes(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

const std::string good = scene("[[object]]\nname = \"o\"\nlist = \"list\"\ncolour = "
                               "\"grey\"\n[[object.box]]\nfrom_m = [0, 0, 0]\nto_m = [1, 1, 1]\n");

TEST(CompileCommand, SaysWhatItMade) {
    const ScratchFolder folder;
    const std::string source = folder.write("good.toml", good);
    const std::string output = folder.path() + "/out.igdb";
    const std::string said = folder.path() + "/said";
    EXPECT_EQ(run(source + " -o " + output + " >" + said), 0);
    EXPECT_EQ(
        bytes(said),
        "t: 6 faces (6 at most at once), 12 edges, 8 vertices, 0 light points, 0 planes, 0 faces cut, in "
        "1 lists and 1 clusters\n");
    EXPECT_GT(bytes(output).size(), 100U);
    EXPECT_EQ(run(source + " -o " + folder.path() + "/again.igdb --json >" + said), 0);
    EXPECT_THAT(bytes(said), HasSubstr("\"faces\": 6"));
    EXPECT_EQ(bytes(output), bytes(folder.path() + "/again.igdb"));
}

TEST(CompileCommand, RefusesMistakesAndWritesNothing) {
    const ScratchFolder folder;
    const std::string source = folder.write("bad.toml", good + "[[object]]\nnaem = \"x\"\n");
    const std::string output = folder.path() + "/out.igdb";
    const std::string said = folder.path() + "/said";
    EXPECT_EQ(run(source + " -o " + output + " 2>" + said), 2);
    EXPECT_THAT(bytes(said), HasSubstr("bad.toml:23:1: error: unknown key \"naem\""));
    EXPECT_FALSE(std::filesystem::exists(output));
    EXPECT_EQ(run(folder.path() + "/absent.toml -o " + output + " 2>" + said), 2);
    EXPECT_EQ(run(folder.path() + " -o " + output + " 2>" + said), 2);
    EXPECT_FALSE(std::filesystem::exists(output));
}

TEST(CompileCommand, TellsOfAnOutputThatCannotBeWritten) {
    const ScratchFolder folder;
    const std::string source = folder.write("good.toml", good);
    const std::string said = folder.path() + "/said";
    EXPECT_EQ(run(source + " -o " + folder.path() + "/no/such/folder/out.igdb 2>" + said), 3);
    EXPECT_THAT(bytes(said), HasSubstr("/no/such/folder/out.igdb"));
}

} // namespace
} // namespace linkdig::database

#endif
