/// Every sea can stand in the place of every other.

#include "tests/database/compiler/authored.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>

namespace linkdig::database {
namespace {

namespace fs = std::filesystem;

/// Sea files by name, without those that others include.
std::map<std::string, fs::path> seas() {
    std::map<std::string, fs::path> found;
    for (const fs::directory_entry& each : fs::directory_iterator(LINKDIG_SOURCE_DIR "/database/scenes/seas"))
        if (each.path().stem() != "mounds_plane") found[each.path().stem().string()] = each.path();
    return found;
}

TEST(Seas, EachGivesTheListAndTheClusterThatShipsFloatOn) {
    const ScratchFolder folder;
    EXPECT_GE(seas().size(), 13U);
    for (const auto& [name, path] : seas()) {
        const std::string include = fs::relative(path, folder.path()).generic_string();
        const CompileResult result = compile_file(
            folder.write(name + ".toml", "include = [\"" + include +
                                             "\"]\n[database]\nname = \"t\"\n[[sun]]\nname = \"ocean\"\n"));
        ASSERT_TRUE(result.database) << messages(result);
        const VisualDatabase& d = *result.database;
        const auto sea =
            std::find_if(d.lists.begin(), d.lists.end(), [](const ObjectList& l) { return l.name == "sea"; });
        ASSERT_NE(sea, d.lists.end()) << name;
        EXPECT_EQ(d.suns[sea->sun], "ocean") << name;
        EXPECT_EQ(d.clusters[sea->cluster].name, "sea") << name;
        EXPECT_EQ(d.groups[d.clusters[sea->cluster].group].number, 20) << name;
    }
}

/// The ray caster's check at length takes shipped databases: each sea is in one, or nothing holds it against anything.
TEST(Seas, EachIsInADatabaseThatIsShipped) {
    std::set<std::string> shipped;
    for (const fs::directory_entry& each :
         fs::directory_iterator(LINKDIG_SOURCE_DIR "/database/scenes/report")) {
        if (!each.path().stem().string().ends_with("_database")) continue;
        const CompileResult result = compile_file(each.path().string());
        EXPECT_TRUE(result.database) << messages(result);
        for (const std::string& file : result.files)
            shipped.insert(fs::path(file).filename().string());
    }
    for (const fs::directory_entry& each : fs::directory_iterator(LINKDIG_SOURCE_DIR "/database/scenes/seas"))
        EXPECT_TRUE(shipped.contains(each.path().filename().string())) << each.path();
}

} // namespace
} // namespace linkdig::database
