#include "host/panel/mapping.h"

#include "database/model/mathematics.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <set>

namespace linkdig::panel {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class MappingFile : public testing::Test {
protected:
    MappingFile() {
        std::string name = (std::filesystem::temp_directory_path() / "linkdig_mapping_XXXXXX").string();
        folder_ = mkdtemp(name.data());
    }
    ~MappingFile() override { std::filesystem::remove_all(folder_); }
    MappingResult read(const std::string& text) const {
        const std::string path = folder_ + "/m.toml";
        std::ofstream(path) << text;
        return load_mapping(path);
    }
    /// The mistakes, each "line:column: message" without what precedes it.
    std::vector<std::string> mistakes(const std::string& text) const {
        std::vector<std::string> all;
        const MappingResult result = read(text);
        EXPECT_EQ(result.mapping.has_value(), !result.diagnostics.any());
        for (const database::Diagnostic& each : result.diagnostics.all())
            all.push_back(std::to_string(each.at.line) + ": " + each.message);
        return all;
    }
    std::string folder_;
};

constexpr const char* switch_head = "[panel]\nkind = \"switch\"\n";
constexpr const char* multi_head = "[panel]\nkind = \"multi\"\n";

TEST_F(MappingFile, TheShippedOnesAreInOrderAndUseEveryControl) {
    for (std::size_t i = 0; i < panel_kinds; ++i) {
        const PanelLayout& layout = layout_of(static_cast<PanelKind>(i));
        const MappingResult result =
            load_mapping(std::string(LINKDIG_SOURCE_DIR "/host/panel/mappings/") + layout.name + ".toml");
        ASSERT_TRUE(result.mapping) << result.diagnostics.text();
        const Mapping& mapping = *result.mapping;
        EXPECT_EQ(mapping.kind, layout.kind);
        std::set<std::size_t> used;
        for (const SwitchBinding& each : mapping.switches)
            used.insert(each.control);
        for (const SelectorBinding& each : mapping.selectors)
            used.insert(each.control);
        for (const ButtonBinding& each : mapping.buttons)
            used.insert(each.control);
        for (const EncoderBinding& each : mapping.encoders) {
            used.insert(each.control);
            if (each.when) used.insert(each.when->control);
        }
        EXPECT_EQ(used.size(), layout.controls.size()) << layout.name;
        std::set<std::size_t> shown;
        for (const LampBinding& each : mapping.lamps)
            shown.insert(each.lamp);
        EXPECT_EQ(shown.size(), layout.lamps.size()) << layout.name;
        shown.clear();
        for (const DisplayBinding& each : mapping.displays)
            shown.insert(each.display);
        EXPECT_EQ(shown.size(), layout.displays.size()) << layout.name;
        EXPECT_GE(mapping_lines(mapping).size(), layout.controls.size());
    }
}

TEST_F(MappingFile, NoSwitchesOfTwoShippedOnesWriteTheSameSignal) {
    std::set<host::Signal> written;
    for (const char* name : {"switch", "multi", "radio"}) {
        const MappingResult result =
            load_mapping(std::string(LINKDIG_SOURCE_DIR "/host/panel/mappings/") + name + ".toml");
        ASSERT_TRUE(result.mapping);
        for (const SwitchBinding& each : result.mapping->switches)
            EXPECT_TRUE(written.insert(each.signal).second) << name << host::definition(each.signal).name;
        for (const SelectorBinding& each : result.mapping->selectors)
            EXPECT_TRUE(written.insert(each.signal).second) << name << host::definition(each.signal).name;
    }
}

TEST_F(MappingFile, ReadsEveryKindOfBinding) {
    const MappingResult result = read(std::string(multi_head) + R"(port = "3-1.4"
[[switch]]
input = "auto_throttle"
signal = "sun_elevation"
on_deg = 10
off_deg = -10
[[selector]]
input = "selector"
signal = "sea_state"
values = { alt = 1, crs = 3 }
[[button]]
input = "selector"
at = "hdg"
signal = "reset"
[[button]]
input = "ap"
when = "selector.ias"
signal = "view"
step = -1
wrap = true
[[encoder]]
input = "trim"
signal = "time_of_day"
step_h = 0.5
[[lamp]]
lamp = "nav"
shows = "ship_roll"
at_least = -2
below = 2
[[display]]
display = "bottom"
when = "selector.vs"
shows = "sea_state"
)");
    ASSERT_TRUE(result.mapping) << result.diagnostics.text();
    const Mapping& m = *result.mapping;
    EXPECT_EQ(m.port, "3-1.4");
    EXPECT_NEAR(m.switches[0].on, radians(10.0), 1e-12);
    EXPECT_NEAR(m.switches[0].off, radians(-10.0), 1e-12);
    EXPECT_EQ(m.selectors[0].values[0], 1.0);
    EXPECT_EQ(m.selectors[0].values[1], std::nullopt);
    EXPECT_EQ(m.selectors[0].values[4], 3.0);
    EXPECT_EQ(m.buttons[0].at, 3U);
    EXPECT_EQ(m.buttons[1].when, (Stand{0, 2}));
    EXPECT_EQ(m.buttons[1].step.by, -1.0);
    EXPECT_TRUE(m.buttons[1].step.wraps);
    EXPECT_EQ(m.encoders[0].step.by, 0.5);
    EXPECT_EQ(m.lamps[0].at_least, -2.0);
    EXPECT_EQ(m.lamps[0].below, 2.0);
    EXPECT_EQ(m.displays[0].shows, Shown(host::Indication::sea_state)) << "an indication before a signal";
    EXPECT_THAT(mapping_lines(m),
                ElementsAre(HasSubstr("sun_elevation"), HasSubstr("1 alt, 3 crs"), HasSubstr("selector.hdg"),
                            HasSubstr("view - 1, round and round"), HasSubstr("time_of_day + 0.5"),
                            HasSubstr("from -2 below 2"), HasSubstr("shows sea_state")));
}

TEST_F(MappingFile, AllMistakesAreToldAtOnceWithTheirLines) {
    EXPECT_THAT(
        mistakes(R"([panel]
kind = "switch"
port = "usb3"
colour = 1
[[switch]]
input = "batery"
signal = "freeze"
[[switch]]
input = "nav"
signal = "frezee"
on = 3
[[switch]]
input = "magneto"
signal = "freeze"
[[switch]]
input = "taxi"
signal = "visibility"
[[switch]]
input = "strobe"
signal = "reset"
[[selector]]
input = "magneto"
signal = "sea_state"
values = { off = 9, both = 1.5, middle = 1 }
[[encoder]]
input = "cowl"
signal = "visibility"
step = 0.1
[[lamp]]
lamp = "nose_blue"
shows = "deck_redy"
[[display]]
display = "top"
shows = "heading"
)"),
        testing::UnorderedElementsAre(
            HasSubstr("3: port \"usb3\"; expected bus and port"), HasSubstr("4: unknown key \"colour\""),
            HasSubstr("6: the switch panel's input \"batery\" is unknown; did you mean \"battery\"?"),
            HasSubstr("10: signal \"frezee\" is unknown; did you mean \"freeze\"?"),
            HasSubstr("13: \"magneto\" is a selector; expected a switch or button"),
            HasSubstr("17: \"visibility\" is no switch; expected \"on\" and \"off\""),
            HasSubstr("20: \"reset\" is done once; expected it in [[button]]"),
            HasSubstr("24: \"off\" is 9; expected 0 to 3"),
            HasSubstr("24: \"both\" is 1.5; signal \"sea_state\" takes whole numbers"),
            HasSubstr("24: unknown key \"middle\""),
            HasSubstr("26: \"cowl\" is a switch or button; expected an encoder"),
            HasSubstr("30: the switch panel's lamp \"nose_blue\" is unknown"),
            HasSubstr("31: indication or signal \"deck_redy\" is unknown; did you mean \"deck_ready\"?"),
            HasSubstr("33: the switch panel has no displays")));
}

TEST_F(MappingFile, UnitsStandInTheKeys) {
    EXPECT_THAT(mistakes(std::string(multi_head) +
                         "[[encoder]]\ninput = \"encoder\"\nsignal = \"sun_elevation\"\nstep = 2\n"),
                ElementsAre(HasSubstr("expected \"step_deg\", what a notch adds to \"sea_sun_elevation\""),
                            HasSubstr("unknown key \"step\"")));
}

TEST_F(MappingFile, TwiceTheSameIsAMistake) {
    EXPECT_THAT(
        mistakes(std::string(switch_head) +
                 "[[switch]]\ninput = \"nav\"\nsignal = \"freeze\"\n[[switch]]\ninput = \"nav\"\nsignal = "
                 "\"freeze\"\n[[switch]]\ninput = \"nav\"\nsignal = \"solid\"\n[[lamp]]\nlamp = "
                 "\"nose_red\"\nshows = \"overrun\"\n[[lamp]]\nlamp = \"nose_red\"\nshows = \"freeze\"\n"),
        ElementsAre(HasSubstr("7: \"nav\" writes \"freeze\" already in line 4"),
                    HasSubstr("16: lamp \"nose_red\" shows something already in line 13")));
}

TEST_F(MappingFile, WhatCannotBeIsToldWithWhatCan) {
    const std::string head = multi_head;
    EXPECT_THAT(mistakes("[[switch]]\ninput = \"nav\"\n"), ElementsAre(HasSubstr("[panel] is missing")));
    EXPECT_THAT(mistakes("[panel]\nkind = \"yoke\"\n"),
                ElementsAre(HasSubstr("panel \"yoke\" is unknown; expected one of: switch, multi, radio")));
    EXPECT_THAT(mistakes("panel = 3\n"), ElementsAre(HasSubstr("\"panel\"")));
    EXPECT_THAT(mistakes(head + "[[button]]\ninput = \"ap\"\nsignal = \"visibility\"\n"),
                ElementsAre(HasSubstr("\"visibility\" is no switch; expected \"to\" or \"step\"")));
    EXPECT_THAT(mistakes(head + "[[button]]\ninput = \"selector\"\nsignal = \"reset\"\n"),
                ElementsAre(HasSubstr("is a selector; expected \"at\"")));
    EXPECT_THAT(mistakes(head + "[[button]]\ninput = \"ap\"\nat = \"alt\"\nsignal = \"reset\"\n"),
                ElementsAre(HasSubstr("a button has no positions")));
    EXPECT_THAT(
        mistakes(head +
                 "[[encoder]]\ninput = \"encoder\"\nwhen = \"alt\"\nsignal = \"visibility\"\nstep = 0.1\n"),
        ElementsAre(HasSubstr("expected a selector and its position, such as \"selector.alt\"")));
    EXPECT_THAT(mistakes(head + "[[encoder]]\ninput = \"encoder\"\nwhen = \"selector.dme\"\nsignal = "
                                "\"visibility\"\nstep = 0.1\n"),
                ElementsAre(HasSubstr("expected one of: alt, vs, ias, hdg, crs")));
    EXPECT_THAT(mistakes(head + "[[encoder]]\ninput = \"encoder\"\nsignal = \"visibility\"\nstep = 0\n"),
                ElementsAre(HasSubstr("is 0; expected a step")));
    EXPECT_THAT(mistakes(head + "[[encoder]]\ninput = \"encoder\"\nsignal = \"view\"\nstep = 0.5\n"),
                ElementsAre(HasSubstr("takes whole steps")));
    EXPECT_THAT(mistakes(head + "[[display]]\ndisplay = \"top\"\nshows = \"hour\"\ndecimals = 1\n"),
                ElementsAre(HasSubstr("has no dots; expected 0")));
    EXPECT_THAT(mistakes(head + "[[lamp]]\nlamp = \"ap\"\nshows = \"hour\"\nat_least = 6\nbelow = 5\n"),
                ElementsAre(HasSubstr("never lit")));
    EXPECT_THAT(mistakes("[panel]\nkind = \"radio\"\n[[lamp]]\nlamp = \"ap\"\nshows = \"hour\"\n"),
                ElementsAre(HasSubstr("the radio panel has no lamps")));
    EXPECT_THAT(mistakes("[panel\n"), ElementsAre(HasSubstr("expected TOML")));
    EXPECT_THAT(load_mapping(folder_ + "/none.toml").diagnostics.text(), HasSubstr("no such file"));
}

TEST(MappingFor, ThePortGoesBeforeTheKind) {
    std::vector<Mapping> mappings(3);
    mappings[0].kind = PanelKind::multi;
    mappings[1].path = "any";
    mappings[2].path = "port";
    mappings[2].port = "1-4";
    EXPECT_EQ(mapping_for(mappings, PanelKind::switches, "1-4")->path, "port");
    EXPECT_EQ(mapping_for(mappings, PanelKind::switches, "1-3")->path, "any");
    EXPECT_EQ(mapping_for(mappings, PanelKind::radio, "1-4"), nullptr);
}

} // namespace
} // namespace linkdig::panel
