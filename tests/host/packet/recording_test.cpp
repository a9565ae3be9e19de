#include "host/packet/recording.h"

#include "host/packet/packet_bytes.h"
#include "host/packet/recording_json.h"
#include "tests/host/packet/sample_packet.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>

namespace linkdig {

namespace {

using testing::HasSubstr;
using testing::MatchesRegex;
using testing::StartsWith;

constexpr std::size_t packets = 3;

FramePacket packet_of(std::size_t number) {
    FramePacket packet = number % 2 == 1 ? sample_packet() : FramePacket{};
    packet.frame = number;
    return packet;
}

void write_sample(const std::string& path, std::vector<std::uint8_t> history = {1, 2, 0xff}) {
    RecordingWriter recording(
        path, {.database_id = 0x8899aabbccddeeffULL, .update_rate_hz = 29.97, .database = "sea.toml"},
        history);
    for (std::size_t i = 1; i <= packets; ++i)
        recording.write(packet_of(i));
    EXPECT_EQ(recording.packets(), packets);
    recording.close();
}

std::string contents(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream bytes;
    bytes << file.rdbuf();
    return bytes.str();
}

/// What stopped the reading ("" at an orderly end), and how many packets came before it.
struct Outcome {
    std::string error;
    std::size_t read = 0;
};

Outcome read_through(const std::string& bytes) {
    Outcome outcome;
    try {
        RecordingReader recording(std::make_unique<std::istringstream>(bytes), "it");
        FramePacket packet;
        while (recording.next(packet)) {
            ++outcome.read;
            EXPECT_EQ(difference(packet, packet_of(outcome.read)), "");
        }
    } catch (const std::runtime_error& error) {
        outcome.error = error.what();
    }
    return outcome;
}

std::string refusal(const std::function<void()>& attempt) {
    try {
        attempt();
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return {};
}

TEST(Recording, GivesBackHeaderHistoryAndPackets) {
    const TestFile file("a.rec");
    write_sample(file.path());
    RecordingReader recording(file.path());
    EXPECT_EQ(recording.header(), (RecordingHeader{0x8899aabbccddeeffULL, 29.97, "sea.toml"}));
    EXPECT_EQ(recording.history(), (std::vector<std::uint8_t>{1, 2, 0xff}));
    FramePacket packet;
    for (std::size_t i = 1; i <= packets; ++i) {
        ASSERT_TRUE(recording.next(packet));
        EXPECT_EQ(difference(packet, packet_of(i)), "");
    }
    EXPECT_FALSE(recording.next(packet));
    EXPECT_FALSE(recording.next(packet)); // and stays at its end
}

TEST(Recording, MayBeEmptyAndWithoutHistory) {
    const TestFile file("a.rec");
    RecordingWriter(file.path(), {}).close();
    RecordingReader recording(file.path());
    EXPECT_TRUE(recording.history().empty());
    FramePacket packet;
    EXPECT_FALSE(recording.next(packet));
}

TEST(Recording, IsTheSameForTheSamePackets) {
    const TestFile a("a.rec");
    const TestFile b("b.rec");
    write_sample(a.path());
    write_sample(b.path());
    EXPECT_EQ(contents(a.path()), contents(b.path()));
}

TEST(Recording, EveryCutIsToldWithThePacketsNumber) {
    const TestFile file("a.rec");
    write_sample(file.path());
    const std::string whole = contents(file.path());
    ASSERT_EQ(read_through(whole).error, "");
    std::size_t most = 0;
    for (std::size_t length = 0; length < whole.size(); ++length) {
        const Outcome outcome = read_through(whole.substr(0, length));
        const std::string expected = outcome.read == 0
                                         ? "it: (cannot be read as a recording|packet 1): .*"
                                         : "it: packet " + std::to_string(outcome.read + 1) + ": cut short.*";
        EXPECT_THAT(outcome.error, MatchesRegex(expected)) << length << " bytes";
        EXPECT_GE(outcome.read, most) << "a longer file has no fewer packets";
        most = outcome.read;
    }
    EXPECT_EQ(most, packets); // only the end record was missing
    EXPECT_EQ(read_through(whole.substr(0, whole.size() - 16)).error,
              "it: packet 4: cut short: the end record is missing");
}

TEST(Recording, EveryFlippedBitIsTold) {
    const TestFile file("a.rec");
    write_sample(file.path());
    std::string bytes = contents(file.path());
    for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
        const auto mask = static_cast<char>(1U << (bit % 8));
        bytes[bit / 8] = static_cast<char>(bytes[bit / 8] ^ mask);
        EXPECT_FALSE(read_through(bytes).error.empty()) << "bit " << bit;
        bytes[bit / 8] = static_cast<char>(bytes[bit / 8] ^ mask);
    }
    EXPECT_EQ(read_through(bytes).error, "");
}

TEST(Recording, ALostPacketIsTold) {
    const TestFile file("a.rec");
    write_sample(file.path());
    std::string bytes = contents(file.path());
    constexpr std::size_t head = 40;
    constexpr std::size_t record_head = 16;
    const std::size_t history_end =
        head + record_head + 4 + 8 + 3; // length and path of the database, history
    bytes.erase(history_end, record_head + encode_packet(packet_of(1)).size());
    EXPECT_EQ(read_through(bytes).error, "it: packet 1: damaged: its hash does not fit");
}

TEST(Recording, BytesAfterTheEndAreTold) {
    const TestFile file("a.rec");
    write_sample(file.path());
    const Outcome outcome = read_through(contents(file.path()) + "x");
    EXPECT_EQ(outcome.error, "it: packet 4: damaged: bytes follow the end record");
    EXPECT_EQ(outcome.read, packets);
}

TEST(Recording, AWriterThatWasNotClosedClosesItself) {
    const TestFile file("a.rec");
    { RecordingWriter(file.path(), {}).write(packet_of(1)); }
    EXPECT_EQ(read_through(contents(file.path())).error, "");
}

TEST(Recording, SaysWhyAFileCannotBeReadOrWritten) {
    const TestFile place("d");
    std::filesystem::create_directory(place.path());
    const std::string& folder = place.path();
    const std::string missing = folder + "/no.rec";
    EXPECT_EQ(refusal([&] { RecordingReader{missing}; }),
              missing + ": cannot be read as a recording: there is no such file");
    EXPECT_EQ(refusal([&] { RecordingReader{folder}; }),
              folder + ": cannot be read as a recording: it is not a regular file");
    std::ofstream(folder + "/empty.rec").flush();
    EXPECT_THAT(refusal([&] { RecordingReader{folder + "/empty.rec"}; }), HasSubstr("the file is empty"));
    EXPECT_EQ(refusal([&] { RecordingWriter(folder, {}); }), "cannot write " + folder + ": Is a directory");
    EXPECT_EQ(refusal([&] { RecordingWriter(folder + "/no/a.rec", {}); }),
              "cannot write " + folder + "/no/a.rec: No such file or directory");
    EXPECT_THAT(refusal([&] { RecordingWriter(folder + "/a.rec", {.update_rate_hz = 0.0}); }),
                HasSubstr("the update rate is 0 Hz; expected more than 0"));
    RecordingWriter closed(folder + "/a.rec", {});
    closed.close();
    EXPECT_THAT(refusal([&] { closed.write({}); }), HasSubstr("the recording is closed"));
}

TEST(Recording, AFullDiskIsTold) {
    if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
    EXPECT_EQ(refusal([] {
                  RecordingWriter recording("/dev/full", {});
                  for (int i = 0; i < 1000; ++i)
                      recording.write(sample_packet());
                  recording.close();
              }),
              "cannot write /dev/full: No space left on device");
}

TEST(RecordingJson, GivesBackTheSameFile) {
    const TestFile binary("a.rec");
    const TestFile again("b.rec");
    write_sample(binary.path());
    std::stringstream text;
    RecordingReader recording(binary.path());
    recording_to_json(recording, text);
    EXPECT_THAT(text.str(), StartsWith(R"({"linkdig_recording":1,"database_id":"0x8899aabbccddeeff",)"
                                       R"("update_rate_hz":29.97,"database":"sea.toml","history":"0102ff"})"
                                       "\n{\"frame\":1,"));
    json_to_recording(text, again.path());
    EXPECT_EQ(contents(binary.path()), contents(again.path()));
}

TEST(RecordingJson, CanBeWrittenByHand) {
    const TestFile file("a.rec");
    std::istringstream text("{\"linkdig_recording\": 1}\n{\"frame\": 5}\n");
    json_to_recording(text, file.path());
    RecordingReader recording(file.path());
    EXPECT_EQ(recording.header(), RecordingHeader{});
    FramePacket packet;
    ASSERT_TRUE(recording.next(packet));
    EXPECT_EQ(packet.frame, 5U);
}

TEST(RecordingJson, MistakesAreNamedByTheirLine) {
    const TestFile file("a.rec");
    const auto expect_told = [&](const char* text, const char* told) {
        std::istringstream lines(text);
        EXPECT_EQ(refusal([&] { json_to_recording(lines, file.path()); }), told);
        EXPECT_FALSE(std::filesystem::exists(file.path()));
        EXPECT_FALSE(std::filesystem::exists(file.path() + ".part"));
    };
    expect_told("", "line 1: missing; expected the recording's header");
    expect_told("{\"frame\": 1}\n", "line 1: linkdig_recording: missing");
    expect_told("{\"linkdig_recording\": 2}\n", "line 1: linkdig_recording: expected version 1");
    expect_told(
        "{\"linkdig_recording\": 1, \"rate\": 3}\n",
        "line 1: rate: unknown field; expected one of database, database_id, history, linkdig_recording, "
        "update_rate_hz");
    expect_told("{\"linkdig_recording\": 1, \"history\": \"012\"}\n",
                "line 1: history: expected pairs of hexadecimal digits");
    expect_told("{\"linkdig_recording\": 1, \"history\": \"0x\"}\n",
                "line 1: history: expected pairs of hexadecimal digits");
    expect_told("{\"linkdig_recording\": 1}\n{\"frame\": 1}\n{\"frame\": \"2\"}\n",
                "line 3: frame: expected an integer from 0 to 18446744073709551615");
}

} // namespace

} // namespace linkdig
