#pragma once
/// The link to the panels over USB, on a thread of its own. Built with libusb or without (CMake option LINKDIG_PANEL): without it
/// there is the same interface, and it says why there are no panels.

#include "host/panel/panel_desk.h"
#include "host/panel/panel_user.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace linkdig::panel {

/// Lets whoever sits at the machine open the panels; tools/panel_permission.sh installs it.
inline constexpr const char* permission_rule =
    R"(SUBSYSTEM=="usb", ATTR{idVendor}=="06a3", ATTR{idProduct}=="0d05|0d06|0d67", TAG+="uaccess")";

/// Empty if this program can speak to panels; otherwise why not.
std::string no_panels_because();

/// A panel that is plugged in.
struct FoundPanel {
    PanelPlace place;
    std::string trouble; ///< why it cannot be used; empty: it can
};

/// All that are plugged in now, by port. Throws std::runtime_error if USB cannot be asked.
std::vector<FoundPanel> find_panels();

/// What went over the link so far.
struct LinkCounts {
    std::uint64_t reports = 0;         ///< transfers that brought bytes, of any length
    std::uint64_t failed_reports = 0;  ///< transfers that ended in an error
    std::uint64_t features = 0;        ///< feature reports that a panel took
    std::uint64_t failed_features = 0; ///< that it did not
};

class PanelLink {
public:
    /// Begins at once, and goes on with panels as they come and go. `user` and `tell` are called from the link's thread alone, until
    /// the destructor returns. A trouble is told once for each panel until it is plugged in anew. Throws std::runtime_error
    /// without libusb, or if it cannot begin.
    PanelLink(PanelUser& user, Tell tell);
    /// Leaves the panels dark.
    ~PanelLink();
    PanelLink(const PanelLink&) = delete;
    PanelLink& operator=(const PanelLink&) = delete;

    LinkCounts counts() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace linkdig::panel
