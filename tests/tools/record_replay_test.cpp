// A flight recorded, replayed, left and taken up again: the same packets and the same pictures.

#include "host/packet/packet_bytes.h"
#include "ig/sink/hash_sink.h"
#include "tests/tools/command.h"
#include "tests/tools/pictures.h"
#include "tests/tools/small_flight.h"
#include "tools/flight/bad_input.h"
#include "tools/flight/replay.h"
#include "tools/flight/saved_state.h"
#include "tools/fly/effects.h"

#include <gmock/gmock.h>

namespace linkdig::tools {
namespace {

using host::Signal;
using testing::HasSubstr;

constexpr std::uint64_t frames = 12;

/// Somebody at the controls: takes over in frame 3.
host::SignalValues controls(std::uint64_t frame) {
    host::SignalValues signals;
    signals.set(Signal::hands_on, frame >= 3 ? 1.0 : 0.0);
    signals.set(Signal::stick_fore, 1.0);
    signals.set(Signal::pedals_right, frame >= 6 ? -1.0 : 0.0);
    signals.set(Signal::smooth_shading, frame % 5 == 4 ? 0.0 : 1.0);
    return signals;
}

class RecordReplay : public testing::Test {
protected:
    void SetUp() override {
        Flight flight(small_flight(160, 120, 30.0));
        RecordingWriter recording(folder_.file("flight.rec"), flight.recording_header(), flight.history());
        for (std::uint64_t frame = 0; frame < frames; ++frame) {
            const std::vector<std::uint8_t> before = flight.history();
            flight.draw(frame, controls(frame));
            recording.write(flight.packet());
            pictures_.push_back(ig::picture_hash(flight.machine().picture(0)));
            if (frame == left) save_state(folder_.file("left.state"), flight, before);
        }
        recording.close();
    }
    static constexpr std::uint64_t left = 7;
    TemporaryFolder folder_;
    std::vector<std::uint64_t> pictures_;
};

TEST_F(RecordReplay, GivesTheSamePicturesFromAnyPacketOn) {
    for (const std::uint64_t from : {std::uint64_t{0}, std::uint64_t{5}, frames - 1}) {
        Replay replay(folder_.file("flight.rec"), "", small_flight(160, 120, 30.0).configuration);
        EXPECT_EQ(replay.packets(), frames);
        replay.skip_to(from);
        for (std::uint64_t frame = from; frame < frames; ++frame) {
            EXPECT_EQ(replay.draw().frame, frame);
            EXPECT_EQ(ig::picture_hash(replay.machine().picture(0)), pictures_[frame]) << frame;
        }
        EXPECT_THROW(replay.draw(), BadInput);
    }
}

/// Frame N of a dump is the picture of packet N, wherever the dump begins: so it can be compared with another.
TEST_F(RecordReplay, FilesHaveTheNumbersOfTheirPackets) {
    const std::string replay = "replay " + folder_.file("flight.rec") + " --size 160x120 --threads 1 --out ";
    ASSERT_EQ(run(replay + folder_.file("all")).exit_code, 0);
    const Outcome part = run(replay + folder_.file("part") + " --from 5 --frames 3");
    ASSERT_EQ(part.exit_code, 0) << part.errors;
    EXPECT_THAT(part.output, HasSubstr("frame_000005.png to frame_000007.png"));
    EXPECT_FALSE(std::filesystem::exists(folder_.file("part/frame_000000.png")));
    for (const char* name : {"/frame_000005.png", "/frame_000006.png", "/frame_000007.png"})
        EXPECT_EQ(bytes_of(folder_.file("part") + name), bytes_of(folder_.file("all") + name)) << name;
    // A state that was saved in mid-flight is a recording, too, whose first packet is not that of frame 0.
    const Outcome state =
        run("replay " + folder_.file("left.state") + " --size 160x120 --out " + folder_.file("left"));
    ASSERT_EQ(state.exit_code, 0) << state.errors;
    EXPECT_EQ(bytes_of(folder_.file("left/frame_000007.png")),
              bytes_of(folder_.file("all/frame_000007.png")));
}

TEST_F(RecordReplay, APictureOfAnotherShapeIsWarnedOf) {
    const std::string recording = folder_.file("wide.rec");
    ASSERT_EQ(run("record " + std::string(LINKDIG_SOURCE_DIR) +
                  "/database/scenes/first_flight/approach.toml -o " + recording + " --frames 1 --size 160x80")
                  .exit_code,
              0);
    EXPECT_EQ(run("replay " + recording + " --hashes --size 320x160").errors, "");
    EXPECT_THAT(run("replay " + recording + " --hashes --size 160x160").errors,
                HasSubstr("made for pictures 2 times as wide as high, not for 160 x 160"));
}

/// A flight with wakes that the machine makes of what it remembers, from its middle on.
class WakeReplay : public testing::Test {
protected:
    static constexpr std::uint64_t first = 45U * 4, count = 20; // 4 frames a second
    static FlightRequest request() {
        FlightRequest request = small_flight(160, 120, 4.0);
        request.scenario_path = LINKDIG_SOURCE_DIR "/database/scenes/two_ships/figure_of_eight.toml";
        return request;
    }
    void SetUp() override {
        Flight flight(request());
        flight.lead_in(first, {});
        RecordingWriter recording(folder_.file("wakes.rec"), flight.recording_header(), flight.history());
        for (std::uint64_t k = 0; k < count; ++k) {
            const FrameReport& report = flight.draw(first + k, {});
            ASSERT_EQ(report.wakes.size(), 4U);
            EXPECT_GT(report.wakes[0].faces, 0U);
            recording.write(flight.packet());
            pictures_.push_back(ig::picture_hash(flight.machine().picture(0)));
        }
        recording.close();
    }
    TemporaryFolder folder_;
    std::vector<std::uint64_t> pictures_;
};

TEST_F(WakeReplay, GivesTheSamePicturesFromAnyPacketOn) {
    for (const std::uint64_t from : {std::uint64_t{0}, std::uint64_t{7}, count - 1}) {
        Replay replay(folder_.file("wakes.rec"), "", request().configuration);
        replay.skip_to(from);
        for (std::uint64_t k = from; k < count; ++k) {
            EXPECT_EQ(replay.draw().frame, first + k);
            EXPECT_EQ(ig::picture_hash(replay.machine().picture(0)), pictures_[k]) << k;
        }
    }
}

TEST_F(WakeReplay, GoesThroughTextToTheSameBytes) {
    const Outcome text = run("convert " + folder_.file("wakes.rec") + " -o " + folder_.file("wakes.jsonl"));
    ASSERT_EQ(text.exit_code, 0) << text.errors;
    const Outcome back = run("convert " + folder_.file("wakes.jsonl") + " -o " + folder_.file("again.rec"));
    ASSERT_EQ(back.exit_code, 0) << back.errors;
    EXPECT_EQ(bytes_of(folder_.file("again.rec")), bytes_of(folder_.file("wakes.rec")));
}

TEST_F(RecordReplay, AFlightGoesOnFromItsSavedState) {
    Flight flight(small_flight(160, 120, 30.0));
    const SavedState state = load_state(folder_.file("left.state"), flight.database_id());
    EXPECT_EQ(state.packet.frame, left);
    flight.resume(state.packet, state.history);
    EXPECT_EQ(ig::picture_hash(flight.machine().picture(0)), pictures_[left]);
    for (std::uint64_t frame = left + 1; frame < frames; ++frame) {
        flight.draw(frame, controls(frame));
        EXPECT_EQ(ig::picture_hash(flight.machine().picture(0)), pictures_[frame]) << frame;
    }
}

TEST_F(RecordReplay, AStateCutFromTheRecordingIsTheSavedOne) {
    Replay replay(folder_.file("flight.rec"), "", small_flight(160, 120, 30.0).configuration);
    replay.skip_to(left);
    replay.save_state(folder_.file("cut.state"));
    EXPECT_EQ(bytes_of(folder_.file("cut.state")), bytes_of(folder_.file("left.state")));
}

TEST_F(RecordReplay, MistakesAreTold) {
    const auto told = [](const auto& attempt) -> std::string {
        try {
            attempt();
        } catch (const BadInput& mistake) {
            return mistake.what();
        }
        return "";
    };
    const ig::Configuration configuration = small_flight(160, 120, 30.0).configuration;
    EXPECT_THAT(told([&] { Replay(folder_.file("none.rec"), "", configuration); }),
                HasSubstr("there is no such file"));
    EXPECT_THAT(told([&] { Replay(folder_.file("flight.rec"), "/nowhere.igdb", configuration); }),
                HasSubstr("its database \"/nowhere.igdb\" is not there; --database names another place"));
    EXPECT_THAT(told([&] { Replay(folder_.file("flight.rec"), "", configuration).skip_to(frames); }),
                HasSubstr("has 12 packets; expected 0 to 11"));
    EXPECT_THAT(told([&] { load_state(folder_.file("left.state"), 1); }),
                HasSubstr("was saved with database"));
}

TEST(Effects, SwitchingThereAndBackIsNothing) {
    Flight flight(small_flight(160, 120, 30.0));
    const host::HostLoop& loop = flight.loop();
    for (std::size_t i = 0; i < effect_count; ++i) {
        const auto effect = static_cast<Effect>(i);
        if (!is_possible(effect, loop)) continue;
        const bool before = is_on(effect, {}, loop);
        const host::SignalValues changed = switched(effect, !before, {}, loop);
        EXPECT_EQ(is_on(effect, changed, loop), !before) << effect_name(effect);
        EXPECT_EQ(is_on(effect, switched(effect, before, changed, loop), loop), before)
            << effect_name(effect);
    }
}

TEST(Effects, ThePriceInEdgesIsTheDifferenceOfTheReports) {
    Flight flight(small_flight(160, 120, 30.0));
    const auto edges = [&](const host::SignalValues& signals) {
        return static_cast<std::int64_t>(flight.draw(9, signals).channels[0].edges);
    };
    const std::int64_t smooth = edges({});
    const std::int64_t flat = edges(switched(Effect::smooth_shading, false, {}, flight.loop()));
    EXPECT_GT(smooth, flat) << "smooth faces are cut into triangles";
    const Price price = price_of(Effect::smooth_shading, flight, 9, {});
    EXPECT_EQ(price.edges, smooth - flat);
    EXPECT_THAT(effect_line(Effect::smooth_shading, {}, flight.loop(), price),
                HasSubstr(std::to_string(smooth - flat) + " edges"));
}

} // namespace
} // namespace linkdig::tools
