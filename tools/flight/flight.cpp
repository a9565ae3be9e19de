#include "tools/flight/flight.h"

#include "database/format/name_directory.h"
#include "host/loop/host_values.h"
#include "ig/machine/history_bytes.h"
#include "tools/flight/bad_input.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <stdexcept>
#include <utility>

namespace linkdig::tools {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

host::Scenario scenario_of(const FlightRequest& request) {
    host::ScenarioResult result = host::load_scenario(request.scenario_path);
    if (!result.scenario) throw BadInput(result.diagnostics.text());
    host::Scenario scenario = std::move(*result.scenario);
    scenario.duration_s = request.duration_s.value_or(scenario.duration_s);
    scenario.seed = request.seed.value_or(scenario.seed);
    return scenario;
}

host::HostLoop loop_of(const host::Scenario& scenario, const OpenedDatabase& opened, double update_rate_hz,
                       double picture_aspect) {
    const database::NameDirectory directory = database::name_directory(opened.database, opened.id);
    try {
        return {scenario, directory, update_rate_hz, picture_aspect};
    } catch (const std::invalid_argument& error) {
        throw BadInput(error.what()); // names that the database does not have
    }
}

} // namespace

Flight::Flight(const FlightRequest& request)
    : scenario_(scenario_of(request)), opened_(open_database(scenario_.database_path, &database_files_)),
      picture_aspect_(static_cast<double>(request.configuration.raster.width) /
                      request.configuration.raster.height),
      loop_(loop_of(scenario_, opened_, request.configuration.update_rate_hz, picture_aspect_)),
      configuration_(request.configuration),
      machine_(std::make_unique<ig::Machine>(opened_.database, configuration_)) {}

const FrameReport& Flight::draw(std::uint64_t frame, const host::SignalValues& signals) {
    const Clock::time_point begin = Clock::now();
    const FramePacket& packet = loop_.packet(frame, signals);
    costs_.last_host_s = seconds_since(begin);
    costs_.host_s += costs_.last_host_s;
    return drawn(packet);
}

void Flight::lead_in(std::uint64_t frame, const host::SignalValues& signals) {
    double seconds = 0.0;
    for (const WakeRequest& wake : loop_.packet(frame, signals).wakes)
        seconds = std::max(seconds, static_cast<double>(wake.age_s));
    const auto frames = static_cast<std::uint64_t>(seconds * loop_.update_rate_hz());
    for (std::uint64_t k = frame - std::min(frame, frames); k < frame; ++k)
        machine_->follow(loop_.packet(k, signals));
}

const FrameReport& Flight::resume(const FramePacket& packet, std::span<const std::uint8_t> history) {
    const auto decoded = ig::decode_history(history);
    if (!decoded) throw BadInput("linkdig: error: the saved state's history is none of this program's");
    machine_->restore(*decoded);
    loop_.resume(packet);
    resumed_ = packet;
    return drawn(resumed_);
}

host::SignalValues Flight::resume_host(const FramePacket& packet) {
    loop_.resume(packet);
    return host::signals_of(packet);
}

std::vector<std::uint8_t> Flight::history() const { return ig::encode_history(machine_->history()); }

void Flight::rebuild(const ig::Configuration& configuration) {
    const ig::History history = machine_->history();
    configuration_ = configuration;
    machine_ = std::make_unique<ig::Machine>(opened_.database, configuration_);
    machine_->restore(history);
}

void Flight::replace_database(OpenedDatabase opened) {
    host::HostLoop loop = loop_of(scenario_, opened, loop_.update_rate_hz(), picture_aspect_);
    if (packet_ != nullptr) {
        resumed_ = *packet_; // it lies in the loop that goes
        packet_ = &resumed_;
        loop.resume(resumed_);
    }
    machine_.reset(); // it draws from the database that goes
    opened_ = std::move(opened);
    loop_ = std::move(loop);
    machine_ = std::make_unique<ig::Machine>(opened_.database, configuration_);
}

/// A refused packet is our mistake, but for frames so long after the scenario's duration that ships and eye have gone farther
/// than coordinates do: whoever asked for one can help it.
void Flight::refuse(std::uint64_t frame, const FrameReport& report) const {
    const std::string reasons = fmt::format("{}", fmt::join(report.errors, "; "));
    if (frame >= loop_.frames())
        throw BadInput(
            fmt::format("linkdig: error: frame {} cannot be drawn: {}; the scenario has the frames 0 to {} "
                        "(--frames, --frame)",
                        frame, reasons, loop_.frames() - 1));
    throw std::logic_error(fmt::format("frame {} was refused: {}", frame, reasons));
}

const FrameReport& Flight::drawn(const FramePacket& packet) {
    packet_ = &packet;
    const Clock::time_point begin = Clock::now();
    const FrameReport& report = machine_->frame(packet);
    const double taken_s = seconds_since(begin);
    costs_.last_machine_s = taken_s;
    if (!report.errors.empty()) refuse(packet.frame, report);
    std::uint64_t edges = 0;
    for (const ChannelReport& channel : report.channels)
        edges += channel.edges;
    ++costs_.frames;
    costs_.machine_s += taken_s;
    costs_.worst_s = std::max(costs_.worst_s, taken_s);
    costs_.most_edges = std::max(costs_.most_edges, edges);
    const Overload& overload = report.overload;
    costs_.over_limit += overload.beyond_a_limit() ? 1 : 0;
    costs_.shed += overload.shed() ? 1 : 0;
    if (overload.any() && overload.step + overload.light_step >= costs_.worst.step + costs_.worst.light_step)
        costs_.worst = overload;
    costs_.over_period += taken_s * loop_.update_rate_hz() > 1.0 ? 1 : 0;
    return report;
}

} // namespace linkdig::tools
