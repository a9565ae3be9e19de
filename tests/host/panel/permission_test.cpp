// The udev rule stands in three places: what the message says, what the page shows, what the script installs.

#include "host/panel/panel_link.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <fstream>
#include <sstream>

namespace linkdig::panel {
namespace {

std::string text_of(const char* path) {
    std::ifstream file(path);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

TEST(PermissionRule, IsTheSameInMessagePageAndScript) {
    EXPECT_THAT(text_of(LINKDIG_SOURCE_DIR "/docs/panel.md"), testing::HasSubstr(permission_rule));
    EXPECT_THAT(text_of(LINKDIG_SOURCE_DIR "/tools/panel_permission.sh"),
                testing::HasSubstr(permission_rule));
    for (std::size_t i = 0; i < panel_kinds; ++i) {
        const std::uint16_t product = layout_of(static_cast<PanelKind>(i)).product_id;
        EXPECT_THAT(permission_rule, testing::HasSubstr(fmt::format("{:04x}", product)));
    }
}

TEST(PanelPage, NamesEveryControlLampDisplayAndIndication) {
    const std::string page = text_of(LINKDIG_SOURCE_DIR "/docs/panel.md");
    const auto named = [&](const char* name) {
        return page.find(fmt::format("`{}`", name)) != std::string::npos;
    };
    for (std::size_t i = 0; i < panel_kinds; ++i) {
        const PanelLayout& layout = layout_of(static_cast<PanelKind>(i));
        for (const Control& control : layout.controls) {
            EXPECT_TRUE(named(control.name)) << control.name;
            for (const char* position : control.positions)
                EXPECT_TRUE(named(position)) << position;
        }
        for (const Lamp& lamp : layout.lamps)
            EXPECT_TRUE(named(lamp.name)) << lamp.name;
        for (const Display& display : layout.displays)
            EXPECT_TRUE(named(display.name)) << display.name;
    }
    for (const host::IndicationDefinition& each : host::indication_directory())
        EXPECT_TRUE(named(each.name)) << each.name;
}

} // namespace
} // namespace linkdig::panel
