// linkdig compare as a person runs it: sequences, damage, codes, closing lines, files written.

#include "tests/tools/compare/frames.h"

#include <gmock/gmock.h>

namespace linkdig::tools {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;

/// Two equal sequences of five frames.
class CompareCommand : public testing::Test {
protected:
    void SetUp() override {
        write_sequence(a, "frame", 5);
        write_sequence(b, "frame", 5);
    }
    Outcome compare(const std::string& more = "") const {
        return run("compare " + in_quotes(a) + " " + in_quotes(b) + " " + more);
    }
    static std::string name(int frame) { return "/frame000" + std::to_string(frame) + ".png"; }
    /// Frame `frame` of the actual side with one sample off by `levels`.
    void spoil(int frame, int x, int y, int levels) const {
        Frame picture = test_frame(40, 30, static_cast<unsigned>(frame));
        picture.at(x, y, 1) = static_cast<std::uint8_t>(picture.at(x, y, 1) + levels);
        write_frame(b + name(frame), picture);
    }
    TemporaryFolder folder;
    std::string a = folder.file("expected");
    std::string b = folder.file("actual");
};

TEST_F(CompareCommand, TheSameIsOneLineAndZero) {
    const Outcome outcome = compare();
    EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
    EXPECT_EQ(outcome.output, "same: 5 frames\n");
    EXPECT_EQ(outcome.errors, "");
}

TEST_F(CompareCommand, FirstAndWorstAreTold) {
    spoil(2, 7, 11, 1);
    spoil(4, 20, 3, 60);
    const Outcome outcome = compare();
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_THAT(outcome.output,
                HasSubstr("first frame that differs: frame0002.png: 1 of 1200 compared pixels"));
    EXPECT_THAT(outcome.output, HasSubstr("first at line 11, element 7, channel 1: expected ("));
    EXPECT_THAT(outcome.output, HasSubstr("worst frame: frame0004.png"));
    EXPECT_THAT(outcome.output, HasSubstr("a viewer tells"));
    EXPECT_THAT(outcome.output, EndsWith("differs: 5 frames; 2 differ, first frame0002.png\n"));
    EXPECT_THAT(compare("--scan vertical").output, HasSubstr("first at line 7, element 11"));
}

TEST_F(CompareCommand, SequencesArePairedByNumberWhateverTheirNames) {
    write_sequence(folder.file("c"), "shot_", 5);
    std::filesystem::rename(folder.file("c/shot_0003.png"), folder.file("c/shot_000003.png"));
    EXPECT_EQ(run("compare " + in_quotes(a) + " " + in_quotes(folder.file("c"))).output, "same: 5 frames\n");
}

/// The contact sheet of a dump is no second series, and no extra frame.
TEST_F(CompareCommand, PicturesWithoutANumberBesideFramesDoNotCount) {
    write_sequence(folder.file("c"), "colour_", 5);
    write_frame(b + "/contact.png", test_frame(80, 60));
    const std::string c = in_quotes(folder.file("c"));
    EXPECT_EQ(run("compare " + c + " " + in_quotes(b)).output, "same: 5 frames\n");
    EXPECT_EQ(run("compare " + in_quotes(b) + " " + c).output, "same: 5 frames\n");
    write_frame(a + "/contact.png", test_frame(80, 60, 1)); // both have one: these are compared
    EXPECT_EQ(compare().exit_code, 1);
}

TEST_F(CompareCommand, MissingAndExtraFramesAreNamedWithCode3) {
    std::filesystem::remove(a + name(5));
    std::filesystem::remove(b + name(2));
    spoil(3, 1, 1, 5);
    const Outcome outcome = compare();
    EXPECT_EQ(outcome.exit_code, 3);
    EXPECT_THAT(outcome.output, HasSubstr("missing: 1 frame: frame0002.png\n"));
    EXPECT_THAT(outcome.output, HasSubstr("extra: 1 frame: frame0005.png\n"));
    EXPECT_THAT(
        outcome.output,
        EndsWith("missing or extra frames: 5 frames; 1 missing, 1 extra, 1 differ, first frame0003.png\n"));
    EXPECT_EQ(compare("--frames 3:4").exit_code, 1);
    EXPECT_EQ(compare("--frames 4").output, "same: 1 frame\n");
}

TEST_F(CompareCommand, AnotherSizeAndOtherChannelsHaveCode4) {
    write_frame(b + name(1), test_frame(41, 30, 1));
    Frame grey = test_frame(40, 30, 2);
    grey.channels = 1;
    grey.samples.resize(1200);
    write_frame(b + name(2), grey);
    const Outcome outcome = compare();
    EXPECT_EQ(outcome.exit_code, 4);
    EXPECT_THAT(
        outcome.output,
        HasSubstr("frame0001.png: another size: expected 40 x 30, 3 channels R,G,B, uint8; got 41 x 30"));
    EXPECT_THAT(outcome.output, HasSubstr("frame0002.png: other channels: expected 40 x 30, 3 channels "
                                          "R,G,B, uint8; got 40 x 30, 1 channel"));
}

TEST_F(CompareCommand, DamagedFilesAreNamedWithCode2) {
    // Cut on both sides alike: equal bytes are no proof of a picture.
    for (const std::string& side : {a, b})
        cut_file(side + name(1), std::filesystem::file_size(side + name(1)) - 20);
    cut_file(b + name(2), 60);
    cut_file(b + name(3), 0);
    std::ofstream(b + name(4)) << "no picture at all";
    const Outcome outcome = compare();
    EXPECT_EQ(outcome.exit_code, 2);
    for (const std::string& path : {a + name(1), b + name(2), b + name(4)})
        EXPECT_THAT(outcome.output, HasSubstr(path + ": cannot be read: ")) << path;
    EXPECT_THAT(outcome.output, HasSubstr(b + name(3) + ": is empty; expected a picture"));
    EXPECT_THAT(outcome.output, EndsWith("unreadable: 5 frames; 4 unreadable\n"));
}

TEST_F(CompareCommand, ThingsThatCannotBeComparedAreRefused) {
    std::filesystem::create_directory(folder.file("empty"));
    std::ofstream(folder.file("packets.jsonl")) << "";
    const std::string file = in_quotes(a + name(1));
    for (const auto& [arguments, told] :
         {std::pair(in_quotes(a) + " " + file, std::string("is a folder of frames, ")),
          std::pair(file + " " + in_quotes(a), std::string("is a picture, ")),
          std::pair(in_quotes(a) + " " + in_quotes(folder.file("nowhere")),
                    std::string("there is no such file or folder")),
          std::pair(in_quotes(a) + " " + in_quotes(folder.file("empty")),
                    std::string("no frames in it; expected .png")),
          std::pair(in_quotes(a) + " " + in_quotes(folder.file("packets.jsonl")),
                    std::string("expected --database FILE")),
          std::pair(in_quotes(a), std::string("expected two things to compare")),
          std::pair(in_quotes(a) + " " + in_quotes(b) + " --tolerance 5", std::string("'5' is no tolerance")),
          std::pair(in_quotes(a) + " " + in_quotes(b) + " --exact --tolerance '<=1:*'",
                    std::string("excludes")),
          std::pair(in_quotes(a) + " " + in_quotes(b) + " --ignore 1,2",
                    std::string("'1,2' is no rectangle")),
          std::pair(in_quotes(a) + " " + in_quotes(b) + " --frames 90",
                    std::string("neither side has a frame")),
          std::pair(in_quotes(a) + " " + in_quotes(b) + " --mask " + in_quotes(a),
                    std::string("is a folder"))}) {
        const Outcome outcome = run("compare " + arguments);
        EXPECT_EQ(outcome.exit_code, 2) << arguments;
        EXPECT_EQ(outcome.output, "") << arguments;
        EXPECT_THAT(outcome.errors, HasSubstr(told)) << arguments;
    }
}

TEST_F(CompareCommand, TwoFilesOfOneFrameAreRefused) {
    std::filesystem::copy_file(b + name(3), b + "/frame03.png");
    const Outcome outcome = compare();
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_THAT(outcome.errors, HasSubstr("are the same frame; expected one file for each"));
}

TEST_F(CompareCommand, NamesWithSpacesAndAccents) {
    const std::string odd = folder.file("Sch\xc3\xb6nes Wetter, 2. Flug");
    std::filesystem::rename(b, odd);
    std::filesystem::rename(odd + name(2), odd + "/\xc3\xa9tat de mer 2.png");
    const Outcome outcome = run("compare " + in_quotes(a) + " " + in_quotes(odd));
    EXPECT_EQ(outcome.exit_code, 3);
    EXPECT_THAT(outcome.output, HasSubstr("extra: 1 frame: \xc3\xa9tat de mer 2.png"));
    EXPECT_EQ(run("compare " + in_quotes(a + name(2)) + " " + in_quotes(odd + "/\xc3\xa9tat de mer 2.png") +
                  " --json")
                  .exit_code,
              0);
}

TEST_F(CompareCommand, ToleranceTakesBucketsOfPixels) {
    spoil(2, 7, 11, 1);
    spoil(4, 20, 3, 60);
    EXPECT_EQ(compare("--tolerance '<=1:*'").exit_code, 1);
    const Outcome within = compare("--tolerance '<=1:*,<=60:1'");
    EXPECT_EQ(within.exit_code, 0);
    EXPECT_EQ(within.output, "same: 5 frames; 2 differ within the tolerance\n");
    EXPECT_EQ(compare("--tolerance '<=1:*,<=59:1'").exit_code, 1);
}

TEST_F(CompareCommand, RegionsDecideWhatCounts) {
    spoil(4, 20, 3, 60);
    const Outcome ignored = compare("--ignore 18,0,5,10");
    EXPECT_EQ(ignored.exit_code, 0);
    EXPECT_THAT(ignored.output, HasSubstr("ignored: 1 differing pixel in regions that do not count"));
    EXPECT_EQ(compare("--include 0,0,20,30").exit_code, 0);
    EXPECT_EQ(compare("--include 0,0,21,30").exit_code, 1);
    Frame mask = test_frame(40, 30);
    for (int c = 0; c < 3; ++c)
        mask.at(20, 3, c) = 0;
    write_frame(folder.file("mask.png"), mask);
    EXPECT_EQ(compare("--mask " + in_quotes(folder.file("mask.png"))).exit_code, 0);
    write_frame(folder.file("mask.png"), test_frame(20, 30));
    const Outcome wrong = compare("--mask " + in_quotes(folder.file("mask.png")));
    EXPECT_EQ(wrong.exit_code, 2);
    EXPECT_THAT(wrong.output,
                HasSubstr("frame0004.png: the mask has 20 x 30 pixels; expected the frame's 40 x 30"));
}

TEST_F(CompareCommand, PercentagesAreOfDrawnPixels) {
    Frame dark{40, 30, 3, std::vector<std::uint8_t>(3600, 9)};
    dark.at(3, 3, 0) = 200;
    write_frame(a + name(1), dark);
    dark.at(4, 3, 0) = 100;
    write_frame(b + name(1), dark);
    EXPECT_THAT(compare("--background 9,9,9").output, HasSubstr("1 of 2 drawn pixels (50 %)"));
}

TEST_F(CompareCommand, JsonHoldsWhatTheTextSays) {
    spoil(2, 7, 11, 1);
    std::filesystem::remove(b + name(5));
    const Outcome outcome = compare("--json");
    const nlohmann::json json = json_of(outcome);
    ASSERT_TRUE(json.is_object()) << outcome.output;
    EXPECT_EQ(json["exit_code"], 3);
    const auto& only = json["cases"][0];
    EXPECT_EQ(only["counts"]["same"], 3);
    EXPECT_EQ(only["missing"][0], "frame0005.png");
    EXPECT_EQ(only["first"]["number"], 2);
    EXPECT_EQ(only["first"]["first"]["element"], 7);
    EXPECT_EQ(only["first"]["max"], 1.0);
    EXPECT_NE(only["first"]["expected_hash"], only["first"]["actual_hash"]);
    EXPECT_EQ(json["summary"], "missing or extra frames: 5 frames; 1 missing, 1 differ, first frame0002.png");
}

TEST_F(CompareCommand, JunitHasACasePerFrame) {
    spoil(2, 7, 11, 1);
    const std::string file = folder.file("junit.xml");
    compare("--junit " + in_quotes(file));
    const std::string xml = bytes_of(file);
    EXPECT_THAT(xml, HasSubstr("<testsuite name=\"compare\" tests=\"5\" failures=\"1\" errors=\"0\">"));
    EXPECT_THAT(
        xml, HasSubstr("name=\"frame0002.png\">\n      <failure type=\"differs\" message=\"1 pixels differ"));
}

TEST_F(CompareCommand, OrderDoesNotDependOnThreads) {
    for (int frame = 1; frame <= 5; ++frame)
        spoil(frame, frame, frame, 6 * frame);
    const Outcome one = compare("--threads 1 --json");
    for (int k = 0; k < 5; ++k)
        EXPECT_EQ(compare("--threads 4 --json").output, one.output);
}

TEST_F(CompareCommand, UpdateRewritesOnlyWhatFailed) {
    spoil(2, 7, 11, 1);
    cut_file(a + name(3), 50); // a broken reference is made anew
    cut_file(b + name(4), 50); // a broken picture is no reference
    const std::string good = bytes_of(a + name(4));
    const auto untouched = std::filesystem::last_write_time(a + name(1));
    const Outcome outcome = compare("--update");
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_THAT(outcome.errors, HasSubstr("updated: 2 references"));
    EXPECT_EQ(bytes_of(a + name(2)), bytes_of(b + name(2)));
    EXPECT_EQ(bytes_of(a + name(3)), bytes_of(b + name(3)));
    EXPECT_EQ(bytes_of(a + name(4)), good);
    EXPECT_EQ(std::filesystem::last_write_time(a + name(1)), untouched);
    EXPECT_EQ(compare("--frames 1:3").output, "same: 3 frames\n");
}

TEST_F(CompareCommand, UpdateFillsAFolderWithoutPictures) {
    std::filesystem::create_directories(folder.file("new"));
    write_sequence(folder.file("drawn"), "frame", 2);
    const std::string both =
        "compare " + in_quotes(folder.file("new")) + " " + in_quotes(folder.file("drawn"));
    EXPECT_THAT(run(both).errors, HasSubstr("no frames in it"));
    EXPECT_THAT(run(both + " --update").errors, HasSubstr("updated: 2 references"));
    EXPECT_EQ(run(both).output, "same: 2 frames\n");
}

TEST_F(CompareCommand, LargePicturesAreJudgedByAViewersEyeOnlyWhenAsked) {
    for (const int width : {320, 400}) {
        Frame off = test_frame(width, 320);
        write_frame(folder.file("a.png"), off);
        for (int k = 0; k < 3000; ++k)
            off.at(100 + k % 60, 100 + k / 60, 1) ^= 0x80;
        write_frame(folder.file("b.png"), off);
        const std::string both =
            "compare " + in_quotes(folder.file("a.png")) + " " + in_quotes(folder.file("b.png"));
        const auto told = [](const Outcome& outcome) {
            return outcome.output.find("a viewer tells") != std::string::npos;
        };
        EXPECT_EQ(told(run(both)), width == 320);
        EXPECT_TRUE(told(run(both + " --perceptual")));
    }
}

TEST_F(CompareCommand, OtherKindsOfFilesHoldTheSamePicture) {
    const Frame picture = test_frame(40, 30, 1);
    write_frame(folder.file("eight.png"), picture);
    for (const char* name : {"sixteen.tif", "half.exr", "float.exr"}) {
        const bool sixteen = std::string(name) == "sixteen.tif";
        const OIIO::TypeDesc type = sixteen                           ? OIIO::TypeDesc::UINT16
                                    : std::string(name) == "half.exr" ? OIIO::TypeDesc::HALF
                                                                      : OIIO::TypeDesc::FLOAT;
        write_frame(folder.file(name), picture, type);
        // A half's rounding stays under a tenth of a level.
        const Outcome outcome = run("compare " + in_quotes(folder.file("eight.png")) + " " +
                                    in_quotes(folder.file(name)) + " --tolerance '<=0.1:*'");
        EXPECT_EQ(outcome.exit_code, 0) << name << outcome.output;
        if (sixteen) {
            EXPECT_EQ(outcome.output, "same: 1 frame\n");
        }
        Frame off = picture;
        off.at(1, 1, 1) = static_cast<std::uint8_t>(off.at(1, 1, 1) + 1);
        write_frame(folder.file(name), off, type);
        const Outcome differs = run("compare " + in_quotes(folder.file("eight.png")) + " " +
                                    in_quotes(folder.file(name)) + " --tolerance '<=0.1:*'");
        EXPECT_EQ(differs.exit_code, 1) << name;
        EXPECT_THAT(differs.output, HasSubstr("depth: uint8 against ")) << name;
    }
}

TEST_F(CompareCommand, AFrameOfFiftyMillionPixels) {
    Frame large{8192, 6144, 3, std::vector<std::uint8_t>(std::size_t{8192} * 6144 * 3, 77)};
    write_frame(folder.file("large.png"), large);
    large.at(8191, 6143, 2) = 78;
    write_frame(folder.file("other.png"), large);
    const Outcome outcome =
        run("compare " + in_quotes(folder.file("large.png")) + " " + in_quotes(folder.file("other.png")));
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_THAT(
        outcome.output,
        HasSubstr("first at line 6143, element 8191, channel 2: expected (77 77 77), got (77 77 78)"));
}

TEST_F(CompareCommand, AManifestHoldsCases) {
    spoil(2, 7, 11, 1);
    const std::string file = folder.file("cases.toml");
    std::ofstream(file)
        << "[[case]]\nname = \"one\"\nexpected = \"expected\"\nactual = \"actual\"\ntolerance = [\"<=1:*\"]\n"
           "[[case]]\nname = \"two\"\nexpected = \"expected\"\nactual = \"actual\"\nframes = \"3:5\"\n"
           "tolerance = [\"<=1:*\"]\nwhy = \"nothing differs here\"\n";
    EXPECT_EQ(run("compare --manifest " + in_quotes(file) + " --case one").exit_code, 0);
    const Outcome outcome = run("compare --manifest " + in_quotes(file));
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_THAT(outcome.output,
                HasSubstr("two (nothing differs here):\nbetter than declared: <=1:* expects"));
    EXPECT_THAT(outcome.output,
                EndsWith("differs: 8 frames; 1 differ within the tolerance, 1 case better than declared\n"));
    EXPECT_THAT(run("compare --manifest " + in_quotes(file) + " --case three").errors,
                HasSubstr("there is no case 'three'"));
}

TEST_F(CompareCommand, MistakesInAManifestHaveTheirPlaces) {
    const std::string file = folder.file("cases.toml");
    std::ofstream(file) << "[[case]]\nname = \"one\"\ntolerance = [\"5\"]\nignore = [[1, 2]]\nmsk = "
                           "\"x\"\nbackground = [1, 2]\n";
    const Outcome outcome =
        run("compare --manifest " + in_quotes(file) + " " + in_quotes(a) + " " + in_quotes(b));
    EXPECT_EQ(outcome.exit_code, 2);
    for (const char* told :
         {":3:13: error: '5' is no tolerance", ":4:10: error: ignore is no list of rectangles", ":5:", "mask",
          ":6:14: error: background is no colour"})
        EXPECT_THAT(outcome.errors, HasSubstr(told));
}

} // namespace
} // namespace linkdig::tools
