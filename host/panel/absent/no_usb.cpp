/// The link of a build without libusb.

#include "host/panel/panel_link.h"

#include <stdexcept>

namespace linkdig::panel {

struct PanelLink::State {};

std::string no_panels_because() {
    return "this linkdig was built without libusb-1.0, so it speaks to no panels; with libusb-1.0-0-dev "
           "(tools/setup.sh "
           "installs it) and LINKDIG_PANEL=AUTO or ON a build has them";
}

std::vector<FoundPanel> find_panels() { throw std::runtime_error(no_panels_because()); }

PanelLink::PanelLink(PanelUser& /*user*/, Tell /*tell*/) { throw std::runtime_error(no_panels_because()); }
PanelLink::~PanelLink() = default;
LinkCounts PanelLink::counts() const { return {}; }

} // namespace linkdig::panel
