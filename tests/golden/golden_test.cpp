// A golden is a directory of tests/golden:
//
//   golden.toml     database, machine profile, raster, and in one line why it is there
//   packets.jsonl   a frame packet per line
//   frame_<n>.png   the expected picture of packet <n>'s first channel; channel_<k>_<n>.png of further ones
//
// The pictures are held against the packets by what linkdig compare runs. LINKDIG_UPDATE_GOLDENS=1 rewrites those that
// fail; look at them before they are committed (docs/goldens.md).

#include "database/text/table_reader.h"
#include "tools/compare/compare.h"
#include "tools/compare/read_picture.h"
#include "tools/compare/report_text.h"
#include "tools/compare/update.h"
#include "tools/flight/open_database.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <vector>

namespace linkdig {
namespace {

namespace fs = std::filesystem;

struct Golden {
    fs::path folder;
    std::string database;
    std::string why;
    ig::Configuration configuration;
};

Golden read_golden(const fs::path& folder) {
    Golden golden;
    golden.folder = folder;
    database::Diagnostics diagnostics;
    const std::string path = (folder / "golden.toml").string();
    if (const auto document = database::parse_file(path, diagnostics)) {
        database::TableReader reader(document->root, path, "golden", diagnostics);
        golden.database = (folder / reader.text("database")).string();
        golden.why = reader.text("why");
        if (reader.choice("profile", 0, {"modern", "ames"}) == 1) golden.configuration = ig::ames_profile();
        golden.configuration.raster.width = static_cast<std::uint32_t>(reader.integer("width", 1, 4096));
        golden.configuration.raster.height = static_cast<std::uint32_t>(reader.integer("height", 1, 4096));
        golden.configuration.edge_smoothing = reader.boolean("smoothing", false);
        golden.configuration.threads = 1;
        reader.finish();
    }
    EXPECT_FALSE(diagnostics.any()) << diagnostics.text();
    return golden;
}

/// The directories, by name.
std::vector<fs::path> golden_folders() {
    std::vector<fs::path> folders;
    for (const auto& entry : fs::directory_iterator(fs::path(LINKDIG_SOURCE_DIR) / "tests/golden"))
        if (fs::exists(entry.path() / "golden.toml")) folders.push_back(entry.path());
    std::ranges::sort(folders);
    return folders;
}

void check_golden(const Golden& golden) {
    const tools::OpenedDatabase opened = tools::open_database(golden.database);
    compare::Case which;
    which.name = golden.folder.filename().string();
    which.why = golden.why;
    which.expected = golden.folder.string();
    which.actual = (golden.folder / "packets.jsonl").string();
    compare::Settings settings;
    settings.expected_frames.database = settings.actual_frames.database = &opened.database;
    settings.actual_frames.configuration = golden.configuration;
    settings.scan = golden.configuration.raster.scan;
    settings.threads = 1;
    const bool update = std::getenv("LINKDIG_UPDATE_GOLDENS") != nullptr;
    settings.empty_references = update; // a new golden has no picture yet
    const compare::CaseResult result =
        compare::compare_case(which, settings, [&](const compare::FrameResult& frame) {
            if (update) compare::update_reference(frame, which.expected);
        });
    if (update) {
        EXPECT_TRUE(result.count(compare::Verdict::unreadable) == 0) << compare::closing_line({result});
    } else {
        EXPECT_EQ(result.exit_code(), 0)
            << compare::text_of(result, settings.scan) << compare::closing_line({result});
    }
}

TEST(Golden, EveryDirectoryShowsWhatItShowed) {
    const std::vector<fs::path> folders = golden_folders();
    for (const fs::path& folder : folders) {
        SCOPED_TRACE(folder.filename().string());
        const Golden golden = read_golden(folder);
        EXPECT_FALSE(golden.why.empty());
        check_golden(golden);
    }
    EXPECT_GE(folders.size(), 25U);
}

/// A golden in a scratch folder, to be spoilt.
class SpoiltGolden : public testing::Test {
protected:
    void SetUp() override {
        fs::remove_all(scratch_);
        fs::create_directories(scratch_.parent_path());
        fs::copy(fs::path(LINKDIG_SOURCE_DIR) / "tests/golden/approach", scratch_);
    }
    void TearDown() override { fs::remove_all(scratch_); }
    compare::CaseResult compare_with(const std::string& packets) const {
        Golden golden = read_golden(fs::path(LINKDIG_SOURCE_DIR) / "tests/golden/approach");
        const tools::OpenedDatabase opened = tools::open_database(golden.database);
        compare::Settings settings;
        settings.expected_frames = {&opened.database, 0, golden.configuration};
        settings.actual_frames = settings.expected_frames;
        compare::Case which;
        which.expected = scratch_.string();
        which.actual = packets;
        return compare::compare_case(which, settings, [](const compare::FrameResult&) {});
    }
    /// One for each test: they may run side by side.
    fs::path scratch_ = fs::path(LINKDIG_BUILD_DIR) / "golden_scratch" /
                        testing::UnitTest::GetInstance()->current_test_info()->name();
};

// A golden that cannot fail is none.
TEST_F(SpoiltGolden, OnePixelOffByOneLevelIsADifferenceWithAFaceToIt) {
    const std::string packets = (scratch_ / "packets.jsonl").string();
    EXPECT_EQ(compare_with(packets).exit_code(), 0);
    compare::ReadPicture picture = compare::read_picture((scratch_ / "frame_300.png").string());
    ASSERT_TRUE(picture.picture) << picture.error;
    picture.picture->bytes[3 * (120 * 320 + 160) + 1] ^= 1U;
    compare::FrameResult frame;
    frame.verdict = compare::Verdict::differs;
    frame.expected_path = (scratch_ / "frame_300.png").string();
    frame.actual = std::make_shared<const compare::Picture>(*picture.picture);
    compare::update_reference(frame, scratch_.string());
    const compare::CaseResult result = compare_with(packets);
    ASSERT_EQ(result.exit_code(), 1);
    EXPECT_EQ(result.first->difference.differing, 1U);
    EXPECT_EQ(result.first->difference.largest, 1.0);
    EXPECT_EQ(result.first->difference.first, (compare::Place{160, 120, 1}));
    EXPECT_NE(result.first->first_actual_who.find(", list "), std::string::npos)
        << result.first->first_actual_who;
}

TEST_F(SpoiltGolden, AFrameThatIsGoneIsMissed) {
    fs::remove(scratch_ / "frame_300.png");
    std::ofstream(scratch_ / "frame_301.png") << "";
    const compare::CaseResult result = compare_with((scratch_ / "packets.jsonl").string());
    EXPECT_EQ(result.exit_code(), 3);
    EXPECT_EQ(result.extra, std::vector<std::string>{"frame 300"});
    EXPECT_EQ(result.missing, std::vector<std::string>{"frame_301.png"});
}

} // namespace
} // namespace linkdig
