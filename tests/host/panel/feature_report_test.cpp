#include "host/panel/feature_report.h"

#include <gmock/gmock.h>

#include <limits>

namespace linkdig::panel {
namespace {

using testing::ElementsAre;
using Bytes = std::vector<std::uint8_t>;

Bytes of_lamp(PanelKind kind, std::size_t lamp) {
    PanelFace face = dark_face(layout_of(kind));
    face.lamps[lamp] = true;
    return feature_report(layout_of(kind), face);
}

Bytes of_text(PanelKind kind, std::size_t display, const std::string& text) {
    PanelFace face = dark_face(layout_of(kind));
    face.texts[display] = text;
    const Bytes all = feature_report(layout_of(kind), face);
    const auto first = all.begin() + layout_of(kind).displays[display].first_byte;
    return {first, first + 5};
}

TEST(FeatureReport, EveryLampHasItsBit) {
    const std::array<std::uint8_t, 6> gear{0x01, 0x02, 0x04, 0x08, 0x10, 0x20};
    for (std::size_t i = 0; i < gear.size(); ++i)
        EXPECT_THAT(of_lamp(PanelKind::switches, i), ElementsAre(gear[i])) << i;
    for (std::size_t i = 0; i < 8; ++i) {
        const Bytes bytes = of_lamp(PanelKind::multi, i);
        ASSERT_EQ(bytes.size(), 12U);
        EXPECT_EQ(bytes[10], 1U << i);
        EXPECT_EQ(bytes[11], 0xff);
    }
    EXPECT_EQ(find_lamp(layout_of(PanelKind::switches), "right_red"), 5U);
    EXPECT_EQ(find_lamp(layout_of(PanelKind::multi), "rev"), 7U);
}

TEST(FeatureReport, BothLampsOfAGearAreYellow) {
    PanelFace face = dark_face(layout_of(PanelKind::switches));
    face.lamps.assign(6, true);
    EXPECT_THAT(feature_report(layout_of(PanelKind::switches), face), ElementsAre(0x3f));
}

TEST(FeatureReport, EveryDigitOfEveryDisplay) {
    for (const PanelKind kind : {PanelKind::multi, PanelKind::radio})
        for (std::size_t display = 0; display < layout_of(kind).displays.size(); ++display) {
            EXPECT_THAT(of_text(kind, display, "01234"), ElementsAre(0, 1, 2, 3, 4));
            EXPECT_THAT(of_text(kind, display, "56789"), ElementsAre(5, 6, 7, 8, 9));
            EXPECT_THAT(of_text(kind, display, "7"), ElementsAre(15, 15, 15, 15, 7)) << "to the right";
            EXPECT_THAT(of_text(kind, display, ""), ElementsAre(15, 15, 15, 15, 15));
        }
    EXPECT_EQ(feature_report(layout_of(PanelKind::radio), dark_face(layout_of(PanelKind::radio))).size(),
              22U);
}

TEST(FeatureReport, DashesAndDotsWhereADisplayHasThem) {
    EXPECT_THAT(of_text(PanelKind::multi, 1, "-40"), ElementsAre(15, 15, 0xde, 4, 0));
    EXPECT_THAT(of_text(PanelKind::radio, 2, "-1.5"), ElementsAre(15, 15, 0xe0, 0xd1, 5));
    EXPECT_THAT(of_text(PanelKind::radio, 0, "123.45"), ElementsAre(1, 2, 0xd3, 4, 5));
    EXPECT_THAT(of_text(PanelKind::multi, 0, "-40"), ElementsAre(15, 15, 15, 15, 15)) << "no dash there";
    EXPECT_THAT(of_text(PanelKind::multi, 1, "1.5"), ElementsAre(0xde, 0xde, 0xde, 0xde, 0xde)) << "no dot";
    EXPECT_THAT(of_text(PanelKind::radio, 3, "123456"), ElementsAre(0xe0, 0xe0, 0xe0, 0xe0, 0xe0));
    EXPECT_THAT(of_text(PanelKind::radio, 3, ".5"), ElementsAre(0xe0, 0xe0, 0xe0, 0xe0, 0xe0));
    EXPECT_THAT(of_text(PanelKind::radio, 3, "abc"), ElementsAre(0xe0, 0xe0, 0xe0, 0xe0, 0xe0));
}

TEST(FeatureReport, NumbersAsADisplayShowsThem) {
    const Display& top = layout_of(PanelKind::multi).displays[0];
    const Display& bottom = layout_of(PanelKind::multi).displays[1];
    const Display& radio = layout_of(PanelKind::radio).displays[0];
    EXPECT_EQ(number_text(top, 359.6, 0), "360");
    EXPECT_EQ(number_text(top, 1.5, 3), "2") << "no dots";
    EXPECT_EQ(number_text(top, -7.0, 0), "") << "no dash";
    EXPECT_EQ(number_text(bottom, -7.0, 0), "-7");
    EXPECT_EQ(number_text(bottom, -99999.0, 0), "-----");
    EXPECT_EQ(number_text(radio, -0.04, 1), "0.0");
    EXPECT_EQ(number_text(radio, 1234.56, 2), "-----");
    EXPECT_EQ(number_text(radio, 123.456, 2), "123.46");
    EXPECT_EQ(number_text(radio, 99999.0, 0), "99999");
    EXPECT_EQ(number_text(radio, 1e300, 0), "-----");
    EXPECT_EQ(number_text(radio, -std::numeric_limits<double>::infinity(), 0), "-----");
    EXPECT_EQ(number_text(radio, std::numeric_limits<double>::quiet_NaN(), 0), "");
}

} // namespace
} // namespace linkdig::panel
