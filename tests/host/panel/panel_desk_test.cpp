// What is done at panels, in the signals; what the flight tells, on the panels. The clock is the test's.

#include "host/panel/panel_desk.h"

#include "database/model/mathematics.h"

#include <gmock/gmock.h>

#include <random>

namespace linkdig::panel {
namespace {

using host::Indication;
using host::Signal;
using testing::ElementsAre;
using testing::HasSubstr;

Mapping shipped(const char* name) {
    MappingResult result =
        load_mapping(std::string(LINKDIG_SOURCE_DIR "/host/panel/mappings/") + name + ".toml");
    return std::move(*result.mapping);
}

class Desk : public testing::Test {
protected:
    void send(const PanelPlace& place, std::uint32_t bits, ReportSource source = ReportSource::sent) {
        now_s_ += 0.01;
        desk_.report(place,
                     std::vector<std::uint8_t>{static_cast<std::uint8_t>(bits),
                                               static_cast<std::uint8_t>(bits >> 8U),
                                               static_cast<std::uint8_t>(bits >> 16U)},
                     source, now_s_);
    }
    void notch(const PanelPlace& place, std::uint32_t at_rest, std::uint32_t bit) {
        send(place, at_rest | bit);
        send(place, at_rest);
    }
    std::vector<std::uint8_t> wanted(const PanelPlace& place) { return desk_.wanted(place); }

    host::SignalStore signals_;
    host::IndicationStore indications_;
    std::vector<std::string> told_;
    PanelDesk desk_{{shipped("switch"), shipped("multi"), shipped("radio")},
                    signals_,
                    indications_,
                    [this](const std::string& words) { told_.push_back(words); }};
    double now_s_ = 0.0;
    const PanelPlace switches_{PanelKind::switches, "1-4"};
    const PanelPlace multi_{PanelKind::multi, "1-2"};
    const PanelPlace radio_{PanelKind::radio, "1-1"};
};

constexpr std::uint32_t at_rest = 0x082000; // key at OFF, gear down

TEST_F(Desk, APanelAtRestLeavesTheFlightAsTheScenarioSays) {
    desk_.attached(switches_);
    send(switches_, at_rest);
    EXPECT_EQ(signals_.snapshot(), host::SignalValues());
}

TEST_F(Desk, SwitchesAndSelectorsWriteWhatTheMappingSays) {
    desk_.attached(switches_);
    send(switches_, at_rest | 0x1000); // landing light
    EXPECT_EQ(signals_.value(Signal::pitch_amplitude), 2.0);
    send(switches_, 0x084000); // key at R
    EXPECT_EQ(signals_.value(Signal::pitch_amplitude), 1.0);
    EXPECT_EQ(signals_.value(Signal::sea_state), 1.0);
    send(switches_, 0x010000 | 0x040000); // BOTH, gear up
    EXPECT_EQ(signals_.value(Signal::sea_state), 3.0);
    EXPECT_EQ(signals_.value(Signal::freeze), 1.0);
    send(switches_, 0x010000); // the lever between its stops
    EXPECT_EQ(signals_.value(Signal::freeze), 1.0);
    send(switches_, 0x020000 | 0x080000); // START, gear down
    EXPECT_EQ(signals_.value(Signal::freeze), 0.0);
    EXPECT_EQ(signals_.value(Signal::sea_state), 3.0) << "START names no sea";
    EXPECT_TRUE(signals_.snapshot().on(Signal::reset));
    send(switches_, 0x010000 | 0x080000);
    EXPECT_FALSE(signals_.snapshot().on(Signal::reset)) << "once";
}

TEST_F(Desk, TheSelectorChoosesWhatTheEncoderTurns) {
    desk_.attached(multi_);
    send(multi_, 0x01);
    notch(multi_, 0x01, 0x40);
    EXPECT_NEAR(signals_.value(Signal::visibility), 0.95, 1e-12);
    send(multi_, 0x08);
    notch(multi_, 0x08, 0x20);
    notch(multi_, 0x08, 0x20);
    EXPECT_NEAR(signals_.value(Signal::sea_sun_elevation), radians(4.0), 1e-12);
    EXPECT_NEAR(signals_.value(Signal::visibility), 0.95, 1e-12);
    notch(multi_, 0x08, 0x080000); // trim up
    EXPECT_EQ(signals_.value(Signal::time_of_day), 0.25);
    notch(multi_, 0x08, 0x040000);
    EXPECT_EQ(signals_.value(Signal::time_of_day), 0.0);
}

TEST_F(Desk, ButtonsActWhenTheyArePressed) {
    desk_.attached(multi_);
    send(multi_, 0x01);
    notch(multi_, 0x01, 0x80); // AP
    EXPECT_EQ(signals_.value(Signal::freeze), 1.0);
    notch(multi_, 0x01, 0x80);
    EXPECT_EQ(signals_.value(Signal::freeze), 0.0);
    for (const double view : {1.0, 2.0, 3.0, 0.0}) {
        notch(multi_, 0x01, 0x100); // HDG
        EXPECT_EQ(signals_.value(Signal::view), view);
    }
    send(multi_, 0x01 | 0x20000, ReportSource::asked);
    EXPECT_EQ(signals_.value(Signal::sea_state), 0.0) << "an answer is no press";
    send(multi_, 0x01);
    notch(multi_, 0x01, 0x20000);
    EXPECT_EQ(signals_.value(Signal::sea_state), 1.0);
}

TEST_F(Desk, AfterAllSignalsWereOverwrittenTheSwitchesCountAgain) {
    desk_.attached(switches_);
    desk_.attached(multi_);
    send(switches_, at_rest | 0x1000);
    send(multi_, 0x01);
    notch(multi_, 0x01, 0x80);
    signals_.restore();
    EXPECT_EQ(signals_.value(Signal::pitch_amplitude), 1.0);
    desk_.turn(now_s_);
    EXPECT_EQ(signals_.value(Signal::pitch_amplitude), 2.0);
    EXPECT_EQ(signals_.value(Signal::freeze), 0.0) << "a press is over";
    signals_.write(Signal::pitch_amplitude, 0.5);
    desk_.turn(now_s_);
    EXPECT_EQ(signals_.value(Signal::pitch_amplitude), 0.5) << "somebody else may write it too";
    signals_.assign({});
    desk_.turn(now_s_);
    EXPECT_EQ(signals_.value(Signal::pitch_amplitude), 2.0);
}

TEST_F(Desk, APanelThatComesBackKeepsItsSwitches) {
    desk_.attached(switches_);
    send(switches_, at_rest | 0x1000);
    desk_.detached(switches_);
    EXPECT_EQ(signals_.value(Signal::pitch_amplitude), 2.0);
    desk_.attached(switches_);
    send(switches_, at_rest, ReportSource::asked);
    EXPECT_EQ(signals_.value(Signal::pitch_amplitude), 1.0) << "moved while it was away";
    EXPECT_THAT(told_, ElementsAre("switch panel at 1-4 is connected",
                                   "switch panel at 1-4 has gone; its switches count as they stood",
                                   "switch panel at 1-4 is connected again"));
}

TEST_F(Desk, LampsTellTheDeckAndOverruns) {
    desk_.attached(switches_);
    EXPECT_THAT(wanted(switches_), ElementsAre(0x00));
    indications_.write(Indication::deck_ready, 1.0);
    EXPECT_THAT(wanted(switches_), ElementsAre(0x07)) << "green";
    indications_.write(Indication::overrun, 1.0);
    EXPECT_THAT(wanted(switches_), ElementsAre(0x3f)) << "both: yellow";
    indications_.write(Indication::deck_ready, 0.0);
    EXPECT_THAT(wanted(switches_), ElementsAre(0x38)) << "red";
}

TEST_F(Desk, DisplaysFollowTheSelector) {
    desk_.attached(multi_);
    indications_.write(Indication::altitude_ft, 1234.4);
    indications_.write(Indication::heading, 77.0);
    indications_.write(Indication::ship_heading, 350.0);
    indications_.write(Indication::sea_state, 1.5);
    indications_.write(Indication::sea_sun_height, 24.0);
    const auto digits = [&] {
        std::vector<std::uint8_t> bytes = wanted(multi_);
        bytes.resize(10);
        return bytes;
    };
    EXPECT_THAT(digits(), testing::Each(0x0f)) << "where the selector stands is not known";
    send(multi_, 0x01);
    EXPECT_THAT(digits(), ElementsAre(15, 1, 2, 3, 4, 15, 15, 15, 15, 15));
    send(multi_, 0x08);
    EXPECT_THAT(digits(), ElementsAre(15, 15, 15, 7, 7, 15, 15, 15, 2, 4));
    send(multi_, 0x10);
    EXPECT_THAT(digits(), ElementsAre(15, 15, 3, 5, 0, 15, 15, 1, 0xde, 2)) << "sea state 1-2";
    notch(multi_, 0x10, 0x80);
    EXPECT_EQ(wanted(multi_)[10], 0x05) << "AP: frozen; NAV: smooth shading";
    desk_.attached(radio_);
    send(radio_, 0x0101);
    EXPECT_EQ(wanted(radio_)[1], 1U);
    EXPECT_EQ(wanted(radio_)[4], 4U);
}

TEST_F(Desk, TwoOfAKindHaveEachItsMapping) {
    Mapping other = shipped("switch");
    other.port = "1-5";
    other.switches = {{.control = 12, .signal = Signal::visibility, .on = 0.5, .off = 1.0}};
    PanelDesk desk({shipped("switch"), other}, signals_, indications_, [](const std::string&) {});
    desk.attached(switches_);
    desk.attached({PanelKind::switches, "1-5"});
    const std::vector<std::uint8_t> landing{0x00, 0x30, 0x08};
    desk.report({PanelKind::switches, "1-5"}, landing, ReportSource::sent, 0.0);
    EXPECT_EQ(signals_.value(Signal::visibility), 0.5);
    EXPECT_EQ(signals_.value(Signal::pitch_amplitude), 1.0);
    desk.report(switches_, landing, ReportSource::sent, 0.0);
    EXPECT_EQ(signals_.value(Signal::pitch_amplitude), 2.0);
}

TEST_F(Desk, AFloodMovesNothingButTheSwitches) {
    desk_.attached(multi_);
    send(multi_, 0x04); // IAS: ship_speed, 0.05 a notch
    told_.clear();
    const double begin_s = now_s_ + 1.0;
    for (int i = 0; i < 10000; ++i) // one second's worth at 10,000 a second, half of them notches
        desk_.report(
            multi_,
            std::vector<std::uint8_t>{static_cast<std::uint8_t>(i % 2 == 0 ? 0x24 : 0x04), 0x00, 0x00},
            ReportSource::sent, begin_s + i * 1e-4);
    EXPECT_EQ(signals_.value(Signal::ship_speed), 2.0);
    EXPECT_THAT(told_, ElementsAre(HasSubstr("more than 1000 reports a second")));
    signals_.write(Signal::time_of_day, 0.0);
    const auto burst = [&](std::uint8_t third) {
        for (int i = 0; i < 4000; ++i)
            desk_.report(
                multi_,
                std::vector<std::uint8_t>{0x04, 0x00, static_cast<std::uint8_t>(i % 2 == 0 ? third : 0)},
                ReportSource::sent, begin_s + 1.0);
    };
    burst(0x08);
    EXPECT_LE(signals_.value(Signal::time_of_day), 0.25 * 50) << "what the bucket held";
    desk_.report(multi_, std::vector<std::uint8_t>{0x04, 0x80, 0x00}, ReportSource::sent, begin_s + 1.0);
    EXPECT_EQ(signals_.value(Signal::normals_every), 4.0) << "the last report's switch counts";
    EXPECT_EQ(told_.size(), 1U) << "told once";
}

TEST_F(Desk, GarbageIsToldOnceAndBreaksNothing) {
    desk_.attached(radio_);
    told_.clear();
    std::mt19937 random(5);
    for (int i = 0; i < 20000; ++i) {
        std::vector<std::uint8_t> bytes(random() % 70);
        for (std::uint8_t& byte : bytes)
            byte = static_cast<std::uint8_t>(random());
        desk_.report(radio_, bytes, ReportSource::sent, now_s_ += 0.002);
    }
    EXPECT_THAT(told_, ElementsAre(HasSubstr("expected 3; such reports are passed over")));
    const host::SignalValues values = signals_.snapshot();
    for (const host::SignalDefinition& each : host::signal_directory()) {
        EXPECT_GE(values[each.signal], each.minimum);
        EXPECT_LE(values[each.signal], each.maximum);
    }
}

TEST_F(Desk, PanelsThatNobodyHasPluggedInOrMappedDoNothing) {
    send(switches_, 0xffffff);
    EXPECT_EQ(signals_.snapshot(), host::SignalValues());
    PanelDesk none({}, signals_, indications_, [this](const std::string& words) { told_.push_back(words); });
    none.attached(switches_);
    EXPECT_THAT(told_.back(), HasSubstr("no mapping names it"));
    EXPECT_THAT(none.wanted(switches_), testing::IsEmpty());
}

} // namespace
} // namespace linkdig::panel
