// From the panel to the packet: how many frames, and whether a flood of reports makes one late.

#include "host/loop/frame_clock.h"
#include "host/loop/host_loop.h"
#include "host/loop/instruments.h"
#include "host/packet/packet_bytes.h"
#include "tests/panel/bus_test.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace linkdig::panel {
namespace {

using host::Indication;
using host::Signal;
using testing::HasSubstr;

constexpr double rate_hz = 60.0;

/// A ship, a channel and nothing else.
host::HostLoop small_loop() {
    host::Scenario scenario;
    scenario.duration_s = 60.0;
    scenario.ships.push_back({.moving_object = {"ship", {}},
                              .position_m = {},
                              .heading_rad = 0.0,
                              .speed_mps = 5.0,
                              .motion = {}});
    scenario.approaches.push_back(
        {.ship = {"ship", {}},
         .duration_s = 60.0,
         .path_m = {Vec3d(-400, 0, 50), Vec3d(-300, 0, 40), Vec3d(-200, 0, 30), Vec3d(-100, 0, 20)},
         .first_aim_m = {},
         .last_aim_m = {}});
    scenario.channels.push_back({.name = "ahead", .horizontal_field_rad = 1.0, .vertical_field_rad = 0.8});
    database::NameDirectory directory;
    directory.moving_objects = {"ship"};
    return {scenario, directory, rate_hz};
}

/// Its time is told; nobody sleeps.
class ToldTime final : public host::TimeSource {
public:
    double now_s() override { return now_s_; }
    void sleep_until(double time_s) override { now_s_ = time_s; }

private:
    double now_s_ = 0.0;
};

class PanelFlight : public testing::Test {
protected:
    /// As the window's loop does: wait, snapshot, packet, instruments.
    const FramePacket& frame(host::FrameClock& clock) {
        const std::uint64_t slot = clock.wait();
        const FramePacket& packet = loop_.packet(slot, signals_.snapshot());
        instruments_.read(loop_, packet, clock.overruns(), indications_);
        return packet;
    }
    static std::optional<double> carried(const FramePacket& packet, Signal signal) {
        for (const HostValue& each : packet.host_values)
            if (each.index == static_cast<std::uint32_t>(signal)) return each.value;
        return std::nullopt;
    }

    host::HostLoop loop_ = small_loop();
    host::Instruments instruments_{loop_};
    host::SignalStore signals_;
    host::IndicationStore indications_;
    Words words_;
    MockBus bus_;
    PanelDesk desk_{shipped_mappings(), signals_, indications_, words_.tell()};
};

constexpr std::uint32_t at_rest = 0x082000;

TEST_F(PanelFlight, AReportIsInThePacketOfTheNextFrame) {
    MockPanel panel(bus_, {});
    panel.stand(at_rest);
    const PanelLink link(desk_, words_.tell());
    ASSERT_TRUE(until([&] { return panel.features() >= 1; }));
    ToldTime time;
    host::FrameClock clock(rate_hz, time);
    double worst_ms = 0.0;
    for (int i = 0; i < 100; ++i) {
        const bool on = i % 2 == 0;
        const std::uint64_t before = link.counts().reports;
        EXPECT_EQ(carried(frame(clock), Signal::pitch_amplitude).has_value(), !on);
        const auto sent = std::chrono::steady_clock::now();
        panel.send(on ? at_rest | 0x1000U : at_rest);
        ASSERT_TRUE(until([&] { return link.counts().reports > before; }));
        ASSERT_TRUE(until([&] { return signals_.value(Signal::pitch_amplitude) == (on ? 2.0 : 1.0); }));
        const std::chrono::duration<double, std::milli> passed = std::chrono::steady_clock::now() - sent;
        worst_ms = std::max(worst_ms, passed.count());
        EXPECT_EQ(carried(frame(clock), Signal::pitch_amplitude), on ? std::optional(2.0) : std::nullopt)
            << "one frame after the report";
    }
    EXPECT_EQ(clock.overruns(), 0U);
    fmt::print("report to signal: at most {:.2f} ms of the clock, with umockdev's own share\n", worst_ms);
}

TEST_F(PanelFlight, TheLampsAnswerTheFlight) {
    MockPanel panel(bus_, {});
    MockPanel multi(bus_, {.kind = PanelKind::multi, .device = 5, .port = "2"});
    panel.stand(at_rest | 0x0800); // taxi light
    multi.stand(0x01);
    const PanelLink link(desk_, words_.tell());
    ASSERT_TRUE(until([&] { return signals_.value(Signal::ship_motion) == 0.0; }));
    ToldTime time;
    host::FrameClock clock(rate_hz, time);
    for (int i = 0; i < 90; ++i)
        frame(clock);
    EXPECT_TRUE(until([&] { return panel.feature() == std::vector<std::uint8_t>{0x07}; })) << "green";
    const auto feet = static_cast<int>(std::lround(indications_.value(Indication::altitude_ft)));
    ASSERT_GT(feet, 100);
    EXPECT_TRUE(until([&] {
        const std::vector<std::uint8_t> shown = multi.feature();
        return shown.size() == 12 && shown[2] * 100 + shown[3] * 10 + shown[4] == feet;
    })) << feet;
    time.sleep_until(time.now_s() + 0.2); // a late frame
    frame(clock);
    EXPECT_GT(clock.overruns(), 0U);
    EXPECT_TRUE(until([&] { return panel.feature() == std::vector<std::uint8_t>{0x3f}; }))
        << "and red: yellow";
}

TEST_F(PanelFlight, UnpluggedInFlightItGoesOnAndThePanelComesBack) {
    MockPanel panel(bus_, {});
    panel.stand(at_rest | 0x1000);
    const PanelLink link(desk_, words_.tell());
    ASSERT_TRUE(until([&] { return signals_.value(Signal::pitch_amplitude) == 2.0; }));
    ToldTime time;
    host::FrameClock clock(rate_hz, time);
    frame(clock);
    panel.unplug();
    for (int i = 0; i < 30; ++i)
        EXPECT_EQ(carried(frame(clock), Signal::pitch_amplitude), 2.0) << "its switches count as they stood";
    panel.stand(at_rest | 0x0400);
    panel.plug();
    ASSERT_TRUE(until([&] { return signals_.value(Signal::visibility) == 0.1; }))
        << "moved while it was away";
    EXPECT_EQ(carried(frame(clock), Signal::pitch_amplitude), std::nullopt);
    signals_.restore();
    EXPECT_TRUE(until([&] { return signals_.value(Signal::visibility) == 0.1; })) << "told anew";
    EXPECT_EQ(clock.overruns(), 0U);
}

/// What a flood came to. The clock's figures are judged in the long test alone: on a busy machine a frame may be late without any.
struct FloodResult {
    std::uint64_t reports = 0;
    std::uint64_t frames = 0;
    std::uint64_t late = 0;
    double longest_frame_ms = 0.0; ///< from waking to the packet with its instruments
    double seconds = 0.0;
};

class PanelFlood : public PanelFlight {
protected:
    FloodResult fly(MockPanel& panel, const PanelLink& link, double seconds) {
        FloodResult result;
        const auto time = host::steady_time();
        host::FrameClock clock(rate_hz, *time);
        const std::uint64_t before = link.counts().reports;
        const double begin_s = time->now_s();
        double asked_s = begin_s;
        frame(clock);
        while (time->now_s() - begin_s < seconds) {
            const std::uint64_t slot = clock.wait();
            const double woke_s = time->now_s();
            panel.flood(static_cast<std::uint64_t>((woke_s - asked_s) * 1e4), at_rest | 0x0400);
            asked_s = woke_s;
            const FramePacket& packet = loop_.packet(slot, signals_.snapshot());
            instruments_.read(loop_, packet, clock.overruns(), indications_);
            result.longest_frame_ms = std::max(result.longest_frame_ms, 1e3 * (time->now_s() - woke_s));
            ++result.frames;
        }
        result.late = clock.overruns();
        EXPECT_TRUE(until([&] { return panel.waiting() == 0; }));
        result.seconds = time->now_s() - begin_s; // until the last of them was fetched
        EXPECT_TRUE(until([&] { return signals_.value(Signal::visibility) == 0.1; }))
            << "the last report counts";
        result.reports = link.counts().reports - before;
        fmt::print("{} reports in {:.2f} s ({:.0f} a second); {} frames, {} late, the longest {:.2f} ms\n",
                   result.reports, result.seconds, static_cast<double>(result.reports) / result.seconds,
                   result.frames, result.late, result.longest_frame_ms);
        return result;
    }
    FloodResult flood(double seconds) {
        MockPanel panel(bus_, {.direct = true});
        panel.stand(at_rest);
        const PanelLink link(desk_, words_.tell());
        EXPECT_TRUE(until([&] { return panel.features() >= 1; }));
        return fly(panel, link, seconds);
    }
};

TEST_F(PanelFlood, ASecondOfItLosesNoReport) {
    const FloodResult flown = flood(1.0);
    EXPECT_GT(flown.reports, 9500U) << "10,000 a second were sent";
    EXPECT_THAT(words_.all(), testing::Contains(HasSubstr("more than 1000 reports a second")));
}

TEST_F(PanelFlood, FiveSecondsOfItMakeNoFrameLate) {
    const FloodResult flown = flood(5.0);
    EXPECT_GT(flown.reports, 49000U);
    EXPECT_LT(flown.seconds, 5.1) << "fetched as fast as they came";
    EXPECT_EQ(flown.late, 0U);
}

} // namespace
} // namespace linkdig::panel
