// What a build without libusb says of panels; compiled in every build.

#include "host/panel/panel_link.h"

#include <gmock/gmock.h>

#include <stdexcept>

namespace linkdig::panel {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

TEST(NoLink, SaysWhyThereAreNoPanels) {
    EXPECT_THAT(no_panels_because(), HasSubstr("built without libusb-1.0"));
    EXPECT_THAT(find_panels, ThrowsMessage<std::runtime_error>(no_panels_because()));
}

TEST(NoLink, NoLinkBegins) {
    host::SignalStore signals;
    const host::IndicationStore indications;
    PanelDesk desk({}, signals, indications, [](const std::string&) {});
    EXPECT_THROW(PanelLink(desk, [](const std::string&) {}), std::runtime_error);
}

} // namespace
} // namespace linkdig::panel
