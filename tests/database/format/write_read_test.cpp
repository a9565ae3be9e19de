#include "database/format/file_header.h"
#include "database/format/read.h"
#include "database/format/validate.h"
#include "database/format/write.h"
#include "tests/database/format/sample_database.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <fstream>

namespace linkdig::database {

namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

std::string refusal_of_writing(const VisualDatabase& database, const std::string& path) {
    try {
        write_database(database, path);
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return {};
}

TEST(EncodeDatabase, GivesBackTheSameValue) {
    const VisualDatabase sample = sample_database();
    ASSERT_EQ(validate(sample), "");
    const ReadResult read = decode_database(encode_database(sample));
    ASSERT_TRUE(read.database) << read.error;
    EXPECT_TRUE(*read.database == sample);
    EXPECT_EQ(encode_database(*read.database), encode_database(sample));
}

TEST(EncodeDatabase, TakesAnEmptyDatabase) {
    const ReadResult read = decode_database(encode_database(VisualDatabase{}));
    ASSERT_TRUE(read.database) << read.error;
    EXPECT_TRUE(*read.database == VisualDatabase{});
}

TEST(EncodeDatabase, KeepsTheSignOfZero) {
    VisualDatabase sample = sample_database();
    sample.vertices[0].position.y = -0.0F;
    const ReadResult read = decode_database(encode_database(sample));
    ASSERT_TRUE(read.database) << read.error;
    EXPECT_TRUE(std::signbit(read.database->vertices[0].position.y));
}

// The bytes are the same from every compiler, build type and machine. A change of the format changes this
// number; it must then raise format_version, too.
TEST(EncodeDatabase, GivesTheCommittedBytes) {
    EXPECT_EQ(format_version, 3U);
    EXPECT_EQ(database_id(sample_database()), 10697139326905991954ULL);
}

TEST(EncodeDatabase, IdentityIsThatOfTheContents) {
    VisualDatabase other = sample_database();
    other.vertices[0].position.x = 0.125F;
    const ReadResult read = decode_database(encode_database(other));
    EXPECT_EQ(read.id, database_id(other));
    EXPECT_NE(read.id, database_id(sample_database()));
}

TEST(DecodeDatabase, TakesBytesAtAnyAddress) {
    const std::vector<std::uint8_t> file = encode_database(sample_database());
    for (std::size_t shift = 0; shift < 8; ++shift) {
        std::vector<std::uint8_t> moved(shift, 0);
        moved.insert(moved.end(), file.begin(), file.end());
        const ReadResult read = decode_database(std::span(moved).subspan(shift));
        ASSERT_TRUE(read.database) << read.error;
        EXPECT_TRUE(*read.database == sample_database()) << shift;
    }
}

TEST(WriteDatabase, LeavesOneFileThatCanBeRead) {
    const TestFolder folder;
    const std::string path = folder.file("a.igdb");
    write_database(VisualDatabase{}, path);
    write_database(sample_database(), path); // in the place of the other
    EXPECT_THAT(folder.names(), ElementsAre("a.igdb"));
    const ReadResult read = read_database(path);
    ASSERT_TRUE(read.database) << read.error;
    EXPECT_TRUE(*read.database == sample_database());
    EXPECT_EQ(read.id, database_id(sample_database()));
}

TEST(WriteDatabase, AnUnsoundDatabaseLeavesTheOldFile) {
    const TestFolder folder;
    const std::string path = folder.file("a.igdb");
    write_database(sample_database(), path);
    VisualDatabase unsound = sample_database();
    unsound.faces[0].colour = 9;
    EXPECT_EQ(refusal_of_writing(unsound, path),
              "cannot write " + path +
                  ": the database is not sound: faces[0].colour is 9, but there are 2 colours");
    EXPECT_THAT(folder.names(), ElementsAre("a.igdb"));
    EXPECT_TRUE(read_database(path).database);
}

TEST(WriteDatabase, SaysWhyAFileCannotBeWritten) {
    const TestFolder folder;
    EXPECT_EQ(refusal_of_writing(sample_database(), folder.file("no/a.igdb")),
              "cannot write " + folder.file("no/a.igdb") + ": No such file or directory");
    std::filesystem::create_directory(folder.path() / "d.igdb");
    EXPECT_EQ(refusal_of_writing(sample_database(), folder.file("d.igdb")),
              "cannot write " + folder.file("d.igdb") + ": Is a directory");
    EXPECT_THAT(folder.names(), ElementsAre("d.igdb"));
}

/// Files of this process end at 1000 bytes, as on a disk that is nearly full, while it lives.
class SmallDisk {
public:
    SmallDisk() {
        ::getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit small{.rlim_cur = 1000, .rlim_max = before_.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &small);
        before_handler_ = std::signal(SIGXFSZ, SIG_IGN);
    }
    ~SmallDisk() {
        ::setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, before_handler_);
    }
    SmallDisk(const SmallDisk&) = delete;
    SmallDisk& operator=(const SmallDisk&) = delete;

private:
    rlimit before_{};
    void (*before_handler_)(int) = nullptr;
};

TEST(WriteDatabase, LeavesTheOldFileWhenTheDiskIsFull) {
    const TestFolder folder;
    const std::string path = folder.file("a.igdb");
    write_database(VisualDatabase{}, path);
    ASSERT_GT(encode_database(sample_database()).size(), 1000U);
    std::string refusal;
    {
        const SmallDisk disk;
        refusal = refusal_of_writing(sample_database(), path);
    }
    EXPECT_EQ(refusal, "cannot write " + path + ": File too large");
    EXPECT_THAT(folder.names(), ElementsAre("a.igdb"));
    EXPECT_TRUE(*read_database(path).database == VisualDatabase{});
}

TEST(ReadDatabase, SaysWhyAFileCannotBeRead) {
    const TestFolder folder;
    const auto refusal = [&](const std::string& name) {
        const ReadResult read = read_database(folder.file(name));
        EXPECT_FALSE(read.database);
        EXPECT_EQ(read.id, 0U);
        EXPECT_THAT(read.error, StartsWith(folder.file(name) + ": cannot be read as a visual database: "));
        return read.error;
    };
    EXPECT_THAT(refusal("missing.igdb"), HasSubstr("there is no such file"));
    std::filesystem::create_directory(folder.path() / "folder.igdb");
    EXPECT_THAT(refusal("folder.igdb"), HasSubstr("it is a directory"));
    std::ofstream(folder.file("empty.igdb")).flush();
    EXPECT_THAT(refusal("empty.igdb"), HasSubstr("the file is empty"));
    EXPECT_THAT(refusal("empty.igdb/below"), HasSubstr("no such file"));
    ASSERT_EQ(::mkfifo(folder.file("pipe.igdb").c_str(), 0600), 0);
    EXPECT_THAT(refusal("pipe.igdb"), HasSubstr("it is not a regular file"));
    std::filesystem::create_symlink("loop.igdb", folder.path() / "loop.igdb");
    EXPECT_THAT(refusal("loop.igdb"), HasSubstr("Too many levels of symbolic links"));
    std::ofstream(folder.file("text.igdb"))
        << "[database]\nname = \"first_flight\"\n# a source, not compiled\n";
    EXPECT_THAT(refusal("text.igdb"), HasSubstr("not a compiled visual database"));
}

TEST(ReadDatabase, SaysWhyAForbiddenFileCannotBeRead) {
    if (::geteuid() == 0) GTEST_SKIP() << "nothing is forbidden to root";
    const TestFolder folder;
    write_database(sample_database(), folder.file("a.igdb"));
    ASSERT_EQ(::chmod(folder.file("a.igdb").c_str(), 0), 0);
    EXPECT_THAT(read_database(folder.file("a.igdb")).error, HasSubstr("Permission denied"));
}

} // namespace

} // namespace linkdig::database
