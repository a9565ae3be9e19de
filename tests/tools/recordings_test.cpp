// Recordings that begin and end while the flight goes on.

#include "host/loop/host_values.h"
#include "tests/tools/pictures.h"
#include "tests/tools/small_flight.h"
#include "tools/fly/fly.h"
#include "tools/fly/window.h"

#include <gmock/gmock.h>

#include <cstdlib>
#include <stdexcept>

namespace linkdig::tools {
namespace {

using host::Signal;

std::vector<std::uint64_t> frames_of(const std::string& path) {
    RecordingReader reader(path);
    FramePacket packet;
    std::vector<std::uint64_t> frames;
    while (reader.next(packet))
        frames.push_back(packet.frame);
    return frames;
}

TEST(Recordings, EachTimeThatItIsSwitchedOnAFileOfItsOwnBegins) {
    const TemporaryFolder folder;
    Flight flight(small_flight(64, 48, 60.0));
    Recordings recordings(folder.file("flight.rec"));
    for (std::uint64_t frame = 0; frame < 12; ++frame) {
        recordings.follow(frame % 4 != 3, flight);
        flight.draw(frame, {});
        recordings.write(flight.packet());
    }
    const std::vector<Recorded> all = recordings.finish();
    ASSERT_EQ(all.size(), 3U);
    EXPECT_EQ(all[1].path, folder.file("flight-2.rec"));
    EXPECT_EQ(all[1].packets, 3U);
    EXPECT_THAT(frames_of(folder.file("flight.rec")), testing::ElementsAre(0, 1, 2));
    EXPECT_THAT(frames_of(folder.file("flight-2.rec")), testing::ElementsAre(4, 5, 6));
    EXPECT_THAT(frames_of(folder.file("flight-3.rec")), testing::ElementsAre(8, 9, 10));
}

TEST(Recordings, WhatCannotBeWrittenIsNotRecorded) {
    Flight flight(small_flight(64, 48, 60.0));
    Recordings recordings("/nowhere/flight.rec");
    EXPECT_THROW(recordings.follow(true, flight), std::runtime_error);
    EXPECT_FALSE(recordings.active());
    EXPECT_TRUE(recordings.finish().empty());
}

/// The window's loop with somebody else at the signals.
TEST(FlyWithSignals, OthersSwitchTheRecordingAndReadTheInstruments) {
    setenv("SDL_VIDEODRIVER", "dummy", 1);
    const TemporaryFolder folder;
    Flight flight(small_flight(64, 48, 60.0));
    Window window("test", 64, 48);
    host::SignalStore signals;
    host::IndicationStore indications;
    signals.write(Signal::record, 1.0);
    signals.write(Signal::ship_speed, 0.5);
    signals.write(Signal::channel_select, 7.0); // there is only one: that
    const FlyResult flown = fly(flight, window,
                                {.updates = 5,
                                 .record = folder.file("flight.rec"),
                                 .signals = &signals,
                                 .indications = &indications});
    ASSERT_EQ(flown.recordings.size(), 1U);
    EXPECT_GE(flown.recordings[0].packets, 1U);
    RecordingReader reader(folder.file("flight.rec"));
    FramePacket packet;
    ASSERT_TRUE(reader.next(packet));
    EXPECT_EQ(host::signals_of(packet)[Signal::ship_speed], 0.5);
    EXPECT_EQ(host::signals_of(packet)[Signal::record], 0.0)
        << "a packet does not say whether it is recorded";
    EXPECT_GT(indications.value(host::Indication::altitude_ft), 0.0);
    EXPECT_EQ(indications.value(host::Indication::frame), static_cast<double>(flight.packet().frame));
    unsetenv("SDL_VIDEODRIVER");
}

} // namespace
} // namespace linkdig::tools
