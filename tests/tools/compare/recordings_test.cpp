// Recordings drawn on the fly, planes beside the colour, and the faces that they name.

#include "database/compiler/compile.h"
#include "database/format/write.h"
#include "host/packet/packet_json.h"
#include "host/packet/recording.h"
#include "ig/machine/history_bytes.h"
#include "ig/machine/machine.h"
#include "tests/tools/compare/frames.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <regex>

namespace linkdig::tools {
namespace {

using testing::EndsWith;
using testing::HasSubstr;

const std::string scenes = LINKDIG_SOURCE_DIR "/tests/golden/scenes/";
const std::string drawn_small = " --size 96x72 --no-smoothing";

/// Frames 1 to 4 of a flight past the yard of blocks.
std::vector<FramePacket> flight() {
    std::vector<FramePacket> packets;
    const std::string line = bytes_of(LINKDIG_SOURCE_DIR "/tests/golden/blocks_modern/packets.jsonl");
    for (std::uint64_t frame = 1; frame <= 4; ++frame) {
        FramePacket packet = *from_json(line.substr(0, line.find('\n'))).packet;
        packet.frame = frame;
        packet.channels[0].eye_m.y += static_cast<double>(frame);
        packets.push_back(std::move(packet));
    }
    return packets;
}

void write_recording(const std::string& path, const std::vector<FramePacket>& packets,
                     const std::vector<std::uint8_t>& history = {}) {
    RecordingWriter writer(path, {}, history);
    for (const FramePacket& packet : packets)
        writer.write(packet);
    writer.close();
}

class CompareRecordings : public testing::Test {
protected:
    void SetUp() override {
        write_recording(a, flight());
        write_recording(b, flight());
    }
    Outcome compare(const std::string& more) const {
        return run("compare " + in_quotes(a) + " " + in_quotes(b) + drawn_small + " " + more);
    }
    TemporaryFolder folder;
    std::string a = folder.file("a.rec");
    std::string b = folder.file("b.rec");
    const std::string blocks = "--database " + in_quotes(scenes + "blocks.toml");
};

TEST_F(CompareRecordings, TheSamePacketsDrawTheSame) {
    const Outcome outcome = compare(blocks);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
    EXPECT_EQ(outcome.output, "same: 4 frames\n");
}

// Three fields differ, two of them long before: only the sun's is to blame for the first picture.
TEST_F(CompareRecordings, TheFieldThatChangesThePictureIsFound) {
    std::vector<FramePacket> packets = flight();
    packets[0].time_of_day_h = 3.0F;
    packets[2].time_of_day_h = 3.0F;
    packets[2].suns[0] = {0.6F, 0.0F, 0.8F};
    packets[2].lod_bias = 1.0F;
    write_recording(b, packets);
    const Outcome outcome = compare(blocks);
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_THAT(
        outcome.output,
        HasSubstr("packets: 2 differ, first that of frame 1:\n    time_of_day_h: expected 12.0, got 3.0"));
    EXPECT_THAT(outcome.output,
                testing::ContainsRegex("first picture that differs: frame 3; fields that change it alone:\n  "
                                       "  suns\\[0\\]: expected [^\n]*\n"));
    const nlohmann::json json = json_of(compare(blocks + " --json"))["cases"][0]["packets"];
    EXPECT_EQ(json["first_picture"], 3);
    for (const auto& field : json["picture_fields"])
        EXPECT_EQ(field["changes_picture"], field["field"] == "suns[0]") << field;
}

TEST_F(CompareRecordings, TextWithAPacketALineIsARecording) {
    std::ofstream text(folder.file("b.jsonl"));
    for (const FramePacket& packet : flight())
        text << to_json(packet) << '\n';
    text.close();
    EXPECT_EQ(
        run("compare " + in_quotes(a) + " " + in_quotes(folder.file("b.jsonl")) + drawn_small + " " + blocks)
            .output,
        "same: 4 frames\n");
}

TEST_F(CompareRecordings, AFolderIsHeldAgainstARecordingAndUpdatedFromIt) {
    const std::string frames = folder.file("frames");
    std::filesystem::create_directory(frames);
    write_frame(frames + "/frame_2.png", test_frame(96, 72));
    const std::string command =
        "compare " + in_quotes(frames) + " " + in_quotes(a) + drawn_small + " " + blocks;
    EXPECT_EQ(run(command + " --update").exit_code, 3);
    EXPECT_EQ(run(command).output, "same: 4 frames\n");
    const Outcome refused =
        run("compare " + in_quotes(a) + " " + in_quotes(frames) + drawn_small + " " + blocks + " --update");
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_THAT(refused.errors, HasSubstr("is a recording; --update rewrites pictures"));
}

// At 105 m a tower is the fine one on the way out, the coarse one for a machine that remembers nothing.
TEST_F(CompareRecordings, WhatTheMachineRememberedIsPutBack) {
    const std::string towers = scenes + "details.toml";
    FramePacket packet = flight().front();
    packet.channels[0].attitude = {};
    packet.channels[0].eye_m = {-95.0, 0.0, 5.0};
    const VisualDatabase database = *database::compile_file(towers).database;
    ig::Machine machine(database, ig::modern_profile());
    ASSERT_TRUE(machine.frame(packet).errors.empty());
    packet.channels[0].eye_m.x = -105.0;
    write_recording(a, {packet});
    write_recording(b, {packet}, ig::encode_history(machine.history()));
    const Outcome outcome = compare("--database " + in_quotes(towers) + " --json");
    EXPECT_EQ(outcome.exit_code, 1) << outcome.errors;
    EXPECT_EQ(json_of(outcome)["cases"][0]["packets"]["differing"], 0);
    write_recording(a, {packet}, ig::encode_history(machine.history()));
    EXPECT_EQ(compare("--database " + in_quotes(towers)).output, "same: 1 frame\n");
    write_recording(b, {packet}, std::vector<std::uint8_t>{9, 9});
    EXPECT_THAT(compare("--database " + in_quotes(towers)).errors,
                HasSubstr("linkdig: error: " + b + ": its history is none of this program's"));
}

TEST_F(CompareRecordings, ACutRecordingIsNamed) {
    cut_file(b, std::filesystem::file_size(b) / 2);
    const Outcome outcome = compare(blocks);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_THAT(outcome.errors, HasSubstr(b + ": "));
}

TEST_F(CompareRecordings, APacketThatCannotBeDrawnIsNamed) {
    std::vector<FramePacket> packets = flight();
    packets[1].channels[0].right_tangent = packets[1].channels[0].left_tangent;
    write_recording(b, packets);
    const Outcome outcome = compare(blocks);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_THAT(outcome.output, HasSubstr(b + ": frame 2: cannot be drawn: channels[0]"));
}

// One face's priority is wrong in a copy of the database: a piece of the ring sinks under the apron that it is painted on.
TEST_F(CompareRecordings, AFaceInTheWrongOrderIsNamed) {
    VisualDatabase database = *database::compile_file(scenes + "blocks.toml").database;
    const std::string right = folder.file("right.igdb");
    database::write_database(database, right);
    const auto is_of = [&](const char* object) {
        return [&database, object](const Face& face) { return database.objects[face.object].name == object; };
    };
    // Of the ring's faces the sixth is turned to the eye; the order inside a run is front to back.
    auto ring = std::ranges::find_if(database.faces, is_of("ring"));
    const auto apron = std::ranges::find_if(database.faces, is_of("apron"));
    ASSERT_NE(apron, database.faces.end());
    ASSERT_LT(ring + 6, apron);
    ring += 6;
    const auto number = ring - database.faces.begin();
    const std::uint32_t line = ring->line;
    std::rotate(ring, ring + 1, apron + 1);
    const std::string wrong = folder.file("wrong.igdb");
    database::write_database(database, wrong);
    const Outcome outcome = compare("--database " + in_quotes(right) + " --database " + in_quotes(wrong));
    EXPECT_EQ(outcome.exit_code, 1) << outcome.errors;
    EXPECT_THAT(outcome.output, HasSubstr("first frame that differs: frame 1: "));
    EXPECT_THAT(outcome.output, testing::ContainsRegex("expected face " + std::to_string(number) +
                                                       ", object \"ring\", list ground \\([^)]*blocks.toml:" +
                                                       std::to_string(line) + "\\)"));
    EXPECT_THAT(outcome.output,
                testing::ContainsRegex("got      face [0-9]+, object \"apron\", list ground "));
    EXPECT_THAT(outcome.output, EndsWith("first frame 1\n"));
    // Nothing else differs: every culprit's expected face is that one.
    const nlohmann::json json =
        json_of(compare("--database " + in_quotes(right) + " --database " + in_quotes(wrong) + " --json"));
    for (const auto& shown : json["cases"][0]["first"]["shows"])
        EXPECT_THAT(shown["expected"].get<std::string>(), HasSubstr("face " + std::to_string(number) + ","));
}

TEST(ComparePlanes, PlanesOfRenderNameWhatTheirPicturesShow) {
    const TemporaryFolder folder;
    const std::string scenario = in_quotes(LINKDIG_SOURCE_DIR "/database/scenes/first_flight/approach.toml");
    const std::string render =
        "render " + scenario + " --frames 560 --size 96x72 --planes colour,list,object,face --out ";
    for (const char* side : {"a", "b"})
        ASSERT_EQ(run(render + in_quotes(folder.file(side))).exit_code, 0);
    EXPECT_EQ(run("compare " + in_quotes(folder.file("a")) + " " + in_quotes(folder.file("b"))).output,
              "same: 4 frames\n");
    const std::string picture = folder.file("b/colour_000560.png");
    const auto input = OIIO::ImageInput::open(picture);
    ASSERT_TRUE(input);
    Frame frame{96, 72, 3, std::vector<std::uint8_t>(96 * 72 * 3)};
    input->read_image(0, 0, 0, 3, OIIO::TypeDesc::UINT8, frame.samples.data());
    input->close();
    frame.at(48, 45, 0) ^= 1U;
    write_frame(picture, frame);
    const std::string command = "compare " + in_quotes(folder.file("a")) + " " + in_quotes(folder.file("b"));
    EXPECT_THAT(run(command).output,
                testing::ContainsRegex("shows    face [0-9]+, object [0-9]+, list [0-9]+\n"));
    const std::string database =
        in_quotes(LINKDIG_SOURCE_DIR "/database/scenes/first_flight/first_flight.toml");
    const std::string told = run(command + " --database " + database).output;
    // linkdig why answers the same question by another way.
    const std::string why = run("why " + scenario + " --frame 560 --at 48,45 --size 96x72").output;
    std::smatch seen;
    ASSERT_TRUE(std::regex_search(why, seen, std::regex("seen +([^,]+), object (\"[^\"]+\") (\\([^)]*\\))")))
        << why;
    EXPECT_THAT(told, testing::ContainsRegex("shows    face [0-9]+, object " + seen[2].str() + ", list " +
                                             seen[1].str()));
    EXPECT_THAT(told, HasSubstr(seen[3].str()));
}

} // namespace
} // namespace linkdig::tools
