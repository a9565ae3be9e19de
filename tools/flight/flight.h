#pragma once
/// A flight: a scenario, its database, the host's loop and the machine, put together. The loop's packets go
/// to the machine through the link and nowhere else.

#include "host/loop/host_loop.h"
#include "host/scenario/scenario.h"
#include "ig/machine/machine.h"
#include "tools/flight/open_database.h"

#include <cstdint>
#include <optional>
#include <string>

namespace linkdig::tools {

struct FlightRequest {
    std::string scenario_path;
    std::optional<double> duration_s;  ///< instead of the scenario's
    std::optional<std::uint64_t> seed; ///< instead of the scenario's
    ig::Configuration configuration;   ///< its update rate is the host's
};

/// What the flight cost so far.
struct FlightCosts {
    std::uint64_t frames = 0;
    double machine_s = 0.0;        ///< wall time inside the machine
    double worst_s = 0.0;          ///< of one frame
    std::uint64_t most_edges = 0;  ///< of one frame, all channels
    std::uint64_t over_limit = 0;  ///< frames beyond a limit of the machine
    std::uint64_t shed = 0;        ///< frames drawn with less detail
    Overload worst;                ///< of the frame that was drawn with least
    std::uint64_t over_period = 0; ///< frames that took the machine longer than the update's period
};

class Flight {
public:
    /// Throws BadInput with all mistakes of scenario and database as text, std::runtime_error for the
    /// environment.
    explicit Flight(const FlightRequest& request);
    Flight(const Flight&) = delete;
    Flight& operator=(const Flight&) = delete;

    /// Draws a frame. Throws std::logic_error, with the report's words, if the machine refuses the host's own
    /// packet.
    const FrameReport& draw(std::uint64_t frame, const host::SignalValues& signals);

    const FramePacket& packet() const { return *packet_; } ///< of the last draw()
    ig::Machine& machine() { return machine_; }
    const VisualDatabase& database() const { return opened_.database; }
    const host::Scenario& scenario() const { return scenario_; }
    const host::HostLoop& loop() const { return loop_; }
    const ig::Configuration& configuration() const { return configuration_; }
    const FlightCosts& costs() const { return costs_; }

private:
    host::Scenario scenario_;
    OpenedDatabase opened_;
    host::HostLoop loop_;
    ig::Configuration configuration_;
    ig::Machine machine_;
    const FramePacket* packet_ = nullptr;
    FlightCosts costs_;
};

} // namespace linkdig::tools
