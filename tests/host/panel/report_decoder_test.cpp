#include "host/panel/report_decoder.h"

#include <gmock/gmock.h>

#include <random>
#include <string>

namespace linkdig::panel {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using What = PanelEvent::What;

std::vector<std::uint8_t> report(std::uint32_t bits) {
    return {static_cast<std::uint8_t>(bits), static_cast<std::uint8_t>(bits >> 8U),
            static_cast<std::uint8_t>(bits >> 16U)};
}

/// What has happened, in words.
std::vector<std::string> words(PanelKind kind, const std::vector<PanelEvent>& events) {
    std::vector<std::string> all;
    for (const PanelEvent& each : events) {
        const Control& control = layout_of(kind).controls[each.control];
        const char* what = each.what == What::at    ? control.positions[each.position]
                           : each.what == What::on  ? "on"
                           : each.what == What::off ? "off"
                           : each.what == What::up  ? "up"
                                                    : "down";
        all.push_back(std::string(control.name) + " " + what);
    }
    return all;
}

class Decoder {
public:
    explicit Decoder(PanelKind kind) : kind_(kind), decoder_(kind) {}
    std::vector<std::string> operator()(std::uint32_t bits, ReportSource source = ReportSource::sent) {
        events_.clear();
        EXPECT_TRUE(decoder_.decode(report(bits), source, events_));
        return words(kind_, events_);
    }
    ReportDecoder& decoder() { return decoder_; }
    const std::vector<PanelEvent>& events() const { return events_; }

private:
    PanelKind kind_;
    ReportDecoder decoder_;
    std::vector<PanelEvent> events_;
};

// The bits as the public drivers have them, written down a second time; an empty name belongs to nothing.
struct Sheet {
    PanelKind kind;
    std::array<const char*, report_bits> bits;
};
const Sheet sheets[] = {
    {PanelKind::switches,
     {"battery on",
      "alternator on",
      "avionics on",
      "fuel_pump on",
      "de_ice on",
      "pitot_heat on",
      "cowl on",
      "panel_light on",
      "beacon on",
      "nav on",
      "strobe on",
      "taxi on",
      "landing on",
      "magneto off",
      "magneto right",
      "magneto left",
      "magneto both",
      "magneto start",
      "gear up",
      "gear down",
      "",
      "",
      "",
      ""}},
    {PanelKind::multi,
     {"selector alt",
      "selector vs",
      "selector ias",
      "selector hdg",
      "selector crs",
      "encoder up",
      "encoder down",
      "ap on",
      "hdg on",
      "nav on",
      "ias on",
      "alt on",
      "vs on",
      "apr on",
      "rev on",
      "auto_throttle on",
      "flaps_up on",
      "flaps_down on",
      "trim down",
      "trim up",
      "",
      "",
      "",
      ""}},
    {PanelKind::radio,
     {"upper com1",     "upper com2",       "upper nav1",       "upper nav2",      "upper adf",
      "upper dme",      "upper xpdr",       "lower com1",       "lower com2",      "lower nav1",
      "lower nav2",     "lower adf",        "lower dme",        "lower xpdr",      "upper_act on",
      "lower_act on",   "upper_inner up",   "upper_inner down", "upper_outer up",  "upper_outer down",
      "lower_inner up", "lower_inner down", "lower_outer up",   "lower_outer down"}},
};

TEST(ReportDecoder, EveryBitOfEveryPanel) {
    for (const Sheet& sheet : sheets)
        for (std::size_t bit = 0; bit < report_bits; ++bit) {
            Decoder decode(sheet.kind);
            decode(0);
            const auto heard = decode(1U << bit);
            if (std::string(sheet.bits[bit]).empty())
                EXPECT_THAT(heard, IsEmpty()) << bit;
            else
                EXPECT_THAT(heard, ElementsAre(sheet.bits[bit])) << bit;
        }
}

TEST(ReportDecoder, EveryBitBelongsToOneControlAtMost) {
    for (const Sheet& sheet : sheets) {
        std::uint32_t seen = 0;
        for (const Control& control : layout_of(sheet.kind).controls)
            for (std::size_t i = 0; i < control.bits(); ++i) {
                EXPECT_EQ(seen >> (control.first_bit + i) & 1U, 0U) << control.name;
                seen |= 1U << (control.first_bit + i);
            }
    }
}

TEST(ReportDecoder, TheFirstReportTellsHowEverythingStands) {
    Decoder decode(PanelKind::switches);
    EXPECT_EQ(decode(0x082001).size(), 15U) << "13 switches, key and lever";
    EXPECT_THAT(decode(0x082001), IsEmpty()) << "nothing has changed";
    EXPECT_THAT(decode(0x082000), ElementsAre("battery off"));
}

TEST(ReportDecoder, ASelectorBetweenTwoStopsStaysWhereItWas) {
    Decoder decode(PanelKind::switches);
    decode(0x002000);
    EXPECT_THAT(decode(0x000000), IsEmpty());
    EXPECT_THAT(decode(0x002000), IsEmpty()) << "back at the same stop";
    EXPECT_THAT(decode(0x000000), IsEmpty());
    EXPECT_THAT(decode(0x004000), ElementsAre("magneto right"));
    EXPECT_EQ(decode.decoder().position(13), 1U);
}

TEST(ReportDecoder, NonsenseIsPassedOver) {
    Decoder decode(PanelKind::multi);
    decode(0x000001);
    EXPECT_THAT(decode(0x000003), IsEmpty()) << "a selector at two stops";
    EXPECT_EQ(decode.decoder().position(0), 0U);
    EXPECT_THAT(decode(0x000061), IsEmpty()) << "an encoder turned both ways";
    EXPECT_THAT(decode(0xf00001), IsEmpty()) << "bits of nothing";
}

TEST(ReportDecoder, AnEncoderGivesOneEventForEachNotch) {
    Decoder decode(PanelKind::multi);
    decode(0x000001);
    for (int notch = 0; notch < 3; ++notch) {
        EXPECT_THAT(decode(0x000021), ElementsAre("encoder up"));
        EXPECT_THAT(decode(0x0000a1), ElementsAre("ap on")) << "still the same notch";
        EXPECT_THAT(decode(0x000001), ElementsAre("ap off"));
    }
    EXPECT_THAT(decode(0x000041), ElementsAre("encoder down"));
    EXPECT_THAT(decode(0x000021), ElementsAre("encoder up")) << "turned back without a pause";
}

TEST(ReportDecoder, AnAnswerTellsHowItStandsAndThatNobodyTouchedIt) {
    Decoder decode(PanelKind::multi);
    EXPECT_THAT(decode(0x0000a1, ReportSource::asked), testing::Not(testing::Contains("encoder up")));
    for (const PanelEvent& each : decode.events())
        EXPECT_FALSE(each.fresh);
    EXPECT_THAT(decode(0x000001), ElementsAre("ap off"));
    decode(0x000081);
    EXPECT_TRUE(decode.events()[0].fresh);
}

TEST(ReportDecoder, OtherLengthsAreNoReports) {
    ReportDecoder decoder(PanelKind::radio);
    std::vector<PanelEvent> events;
    for (std::size_t length = 0; length <= 64; ++length)
        EXPECT_EQ(decoder.decode(std::vector<std::uint8_t>(length, 0xff), ReportSource::sent, events),
                  length == report_bytes);
    EXPECT_EQ(events.size(), 2U) << "only the two buttons of the one report";
}

TEST(ReportDecoder, TellsItsStateAgain) {
    Decoder decode(PanelKind::radio);
    std::vector<PanelEvent> events;
    decode.decoder().tell(events);
    EXPECT_THAT(events, IsEmpty()) << "nothing is known";
    decode(0x004101);
    decode.decoder().tell(events);
    EXPECT_THAT(words(PanelKind::radio, events),
                ElementsAre("upper com1", "lower com2", "upper_act on", "lower_act off"));
}

TEST(ReportDecoder, RandomReportsGiveOnlyWhatThePanelHas) {
    std::mt19937 random(17);
    for (const Sheet& sheet : sheets) {
        ReportDecoder decoder(sheet.kind);
        const PanelLayout& layout = layout_of(sheet.kind);
        std::vector<PanelEvent> events;
        for (int i = 0; i < 20000; ++i) {
            events.clear();
            decoder.decode(report(random()), ReportSource::sent, events);
            for (const PanelEvent& each : events) {
                ASSERT_LT(each.control, layout.controls.size());
                const Control& control = layout.controls[each.control];
                ASSERT_TRUE(each.what != What::at || each.position < control.positions.size());
                ASSERT_EQ(each.what == What::at, control.kind == ControlKind::selector);
            }
        }
    }
}

} // namespace
} // namespace linkdig::panel
