#pragma once
/// A flight: a scenario, its database, the host's loop and the machine, put together. The loop's packets go
/// to the machine through the link and nowhere else.

#include "host/loop/host_loop.h"
#include "host/packet/recording.h"
#include "host/scenario/scenario.h"
#include "ig/machine/machine.h"
#include "tools/flight/open_database.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

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
    double machine_s = 0.0;      ///< wall time inside the machine
    double host_s = 0.0;         ///< wall time in which the packets were made
    double last_machine_s = 0.0; ///< of the last frame
    double last_host_s = 0.0;
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

    /// Draws a frame. Throws, with the report's words, if the machine refuses the host's own packet: BadInput for a frame after
    /// the scenario's duration, else std::logic_error.
    const FrameReport& draw(std::uint64_t frame, const host::SignalValues& signals);

    /// Lets the water of the seconds before a frame come about, without drawing it: for pictures from the middle of a flight.
    void lead_in(std::uint64_t frame, const host::SignalValues& signals);

    /// Takes up the flight where a saved one stood: draws its packet; the next frame follows it.
    const FrameReport& resume(const FramePacket& packet, std::span<const std::uint8_t> history);
    /// The packet of a frame, without drawing it.
    const FramePacket& packet_of(std::uint64_t frame, const host::SignalValues& signals) {
        return loop_.packet(frame, signals);
    }
    /// Takes up the flight in the host alone; the signals of then.
    host::SignalValues resume_host(const FramePacket& packet);
    /// What the image generator carries from frame to frame, as one value; empty: nothing.
    std::vector<std::uint8_t> history() const;
    /// The same flight on another machine; its pictures begin with the next draw(). The host's update rate stays.
    void rebuild(const ig::Configuration& configuration);
    /// The same flight, in this frame, over another state of its database; a flown own ship stays where she is, and levels of
    /// detail are chosen anew. Throws BadInput, and changes nothing, if the scenario names what the database no longer has.
    void replace_database(OpenedDatabase opened);

    const FramePacket& packet() const { return *packet_; } ///< of the last draw()
    ig::Machine& machine() { return *machine_; }
    const ig::Machine& machine() const { return *machine_; }
    /// For a recording of this flight.
    RecordingHeader recording_header() const {
        return {.database_id = opened_.id,
                .update_rate_hz = loop_.update_rate_hz(),
                .database = scenario_.database_path};
    }
    const VisualDatabase& database() const { return opened_.database; }
    std::uint64_t database_id() const { return opened_.id; }
    /// What the database was made from when the flight began.
    const std::vector<std::string>& database_files() const { return database_files_; }
    const host::Scenario& scenario() const { return scenario_; }
    const host::HostLoop& loop() const { return loop_; }
    const ig::Configuration& configuration() const { return configuration_; }
    const FlightCosts& costs() const { return costs_; }

private:
    host::Scenario scenario_;
    std::vector<std::string> database_files_;
    OpenedDatabase opened_;
    double picture_aspect_; ///< of the pictures that the channels were made for
    host::HostLoop loop_;
    ig::Configuration configuration_;
    const FrameReport& drawn(const FramePacket& packet);
    [[noreturn]] void refuse(std::uint64_t frame, const FrameReport& report) const;

    std::unique_ptr<ig::Machine> machine_;
    const FramePacket* packet_ = nullptr;
    FramePacket resumed_;
    FlightCosts costs_;
};

} // namespace linkdig::tools
