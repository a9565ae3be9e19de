#include "tests/tools/command.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

namespace linkdig::tools {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

TEST(Convert, TextAndBackIsTheSameRecording) {
    const TemporaryFolder folder;
    const std::string flight = folder.file("a.rec");
    ASSERT_EQ(run("record '" LINKDIG_SOURCE_DIR "/database/scenes/pier/passing.toml' --frames 3 -o " + flight)
                  .exit_code,
              0);
    const Outcome to_text = run("convert " + flight + " -o " + folder.file("a.jsonl"));
    EXPECT_EQ(to_text.exit_code, 0) << to_text.errors;
    const std::string text = bytes_of(folder.file("a.jsonl"));
    EXPECT_THAT(text, StartsWith("{\"linkdig_recording\":1,"));
    EXPECT_EQ(std::ranges::count(text, '\n'), 4);
    EXPECT_EQ(run("convert " + folder.file("a.jsonl") + " -o " + folder.file("b.rec")).exit_code, 0);
    EXPECT_EQ(bytes_of(folder.file("b.rec")), bytes_of(flight));

    // Cut short: the packet is named, and no text is left that looks whole.
    std::filesystem::resize_file(flight, std::filesystem::file_size(flight) - 100);
    const Outcome cut = run("convert " + flight + " -o " + folder.file("c.jsonl"));
    EXPECT_NE(cut.exit_code, 0);
    EXPECT_THAT(cut.errors, HasSubstr(flight + ": "));
    EXPECT_FALSE(std::filesystem::exists(folder.file("c.jsonl")));
    EXPECT_FALSE(std::filesystem::exists(folder.file("c.jsonl.part")));
}

/// The input says which way it goes; a name that says the other way is refused, and what stood there is as it was.
TEST(Convert, NamesAreThoseOfWhatIsWritten) {
    const TemporaryFolder folder;
    const std::string flight = folder.file("a.rec");
    ASSERT_EQ(run("record '" LINKDIG_SOURCE_DIR "/database/scenes/pier/passing.toml' --frames 2 -o " + flight)
                  .exit_code,
              0);
    const std::string text = folder.file("a.jsonl");
    ASSERT_EQ(run("convert " + flight + " -o " + text).exit_code, 0);
    std::ofstream(folder.file("b.jsonl")) << "as it was";
    const Outcome as_text = run("convert " + text + " -o " + folder.file("b.jsonl"));
    EXPECT_EQ(as_text.exit_code, 2);
    EXPECT_THAT(as_text.errors,
                HasSubstr("b.jsonl' cannot be written: its name is that of a text, but of the input comes "
                          "a recording; expected another one, as flight.rec"));
    EXPECT_EQ(bytes_of(folder.file("b.jsonl")), "as it was");
    const Outcome as_recording = run("convert " + flight + " -o " + folder.file("b.rec"));
    EXPECT_EQ(as_recording.exit_code, 2);
    EXPECT_THAT(as_recording.errors, HasSubstr("expected another one, as flight.jsonl"));
    EXPECT_EQ(run("convert " + text + " -o " + folder.file("of_any_name")).exit_code, 0);
}

TEST(Convert, MistakesAreTheAuthorsAndFilesTheEnvironments) {
    const TemporaryFolder folder;
    const std::string text = folder.file("a.jsonl");
    std::ofstream(text) << "{\"linkdig_recording\": 1}\n{\"frame\": 1, \"tme_s\": 0}\n";
    const Outcome mistake = run("convert " + text + " -o " + folder.file("a.rec"));
    EXPECT_EQ(mistake.exit_code, 2);
    EXPECT_THAT(mistake.errors, HasSubstr("linkdig: error: " + text + ": line 2: tme_s: "));
    EXPECT_EQ(run("convert " + folder.file("none") + " -o " + folder.file("a.rec")).exit_code, 2);
    EXPECT_THAT(run("convert " + folder.file("") + " -o " + folder.file("a.rec")).errors,
                HasSubstr("is a folder"));
    std::ofstream(text) << "{\"linkdig_recording\": 1}\n{\"frame\": 1}\n";
    const Outcome nowhere = run("convert " + text + " -o " + folder.file("none/a.rec"));
    EXPECT_EQ(nowhere.exit_code, 3);
    EXPECT_THAT(nowhere.errors, HasSubstr("none/a.rec"));
    EXPECT_THAT(nowhere.errors, HasSubstr("No such file or directory"));
}

} // namespace
} // namespace linkdig::tools
