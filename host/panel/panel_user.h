#pragma once
/// Whoever wants to know of panels and to light them: what the link to the panels calls.

#include "host/panel/layout.h"
#include "host/panel/report_decoder.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace linkdig::panel {

/// Which panel: its kind, and the port that it is plugged into, such as "1-4" or "3-1.4". Two of a kind differ by it.
struct PanelPlace {
    PanelKind kind{};
    std::string port;
    bool operator==(const PanelPlace&) const = default;
};

/// "switch panel at 1-4"
std::string name_of(const PanelPlace& place);

/// All calls come from the link's one thread, with the time of its clock in seconds.
class PanelUser {
public:
    virtual ~PanelUser() = default;
    /// Plugged in and opened, for the first time or again: nothing is lit on it.
    virtual void attached(const PanelPlace& place) = 0;
    /// Unplugged, or it no longer answers; not for panels that the link lets go at its own end.
    virtual void detached(const PanelPlace& place) = 0;
    /// Bytes as they came, of any length.
    virtual void report(const PanelPlace& place, std::span<const std::uint8_t> bytes, ReportSource source,
                        double now_s) = 0;
    /// Between two events, many times a second.
    virtual void turn(double now_s) = 0;
    /// The feature report that the panel is to have; it is sent when it is another than the last one. Empty: none.
    virtual std::vector<std::uint8_t> wanted(const PanelPlace& place) = 0;
};

} // namespace linkdig::panel
