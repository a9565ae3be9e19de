#include "tools/flight/replay.h"

#include "ig/machine/history_bytes.h"
#include "tools/flight/bad_input.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>

namespace linkdig::tools {
namespace {

/// Recordings are the caller's input: what is wrong with them is his mistake.
template <typename Attempt>
auto as_input(const Attempt& attempt) {
    try {
        return attempt();
    } catch (const std::runtime_error& error) {
        throw BadInput(std::string("linkdig: error: ") + error.what());
    }
}

std::vector<std::uint64_t> frame_numbers_of(const std::string& path) {
    RecordingReader recording(path);
    std::vector<std::uint64_t> numbers;
    for (FramePacket packet; recording.next(packet);)
        numbers.push_back(packet.frame);
    return numbers;
}

OpenedDatabase database_of(const std::string& recording, const RecordingHeader& header,
                           const std::string& given) {
    const std::string path = given.empty() ? header.database : given;
    if (path.empty() || !std::filesystem::exists(path))
        throw BadInput(fmt::format(
            "linkdig: error: {}: its database \"{}\" is not there; --database names another place", recording,
            path));
    OpenedDatabase opened = open_database(path);
    if (header.database_id != 0 && opened.id != header.database_id)
        throw BadInput(fmt::format("linkdig: error: {}: was made with database {:016x}; {} is {:016x}",
                                   recording, header.database_id, path, opened.id));
    return opened;
}

} // namespace

Replay::Replay(const std::string& recording, const std::string& database,
               const ig::Configuration& configuration)
    : path_(recording), configuration_(configuration),
      recording_(as_input([&] { return std::make_unique<RecordingReader>(recording); })),
      opened_(database_of(recording, recording_->header(), database)),
      frame_numbers_(as_input([&] { return frame_numbers_of(recording); })) {
    configuration_.update_rate_hz = recording_->header().update_rate_hz;
    machine_ = std::make_unique<ig::Machine>(opened_.database, configuration_);
    const auto decoded = ig::decode_history(recording_->history());
    if (!decoded)
        throw BadInput(fmt::format("linkdig: error: {}: its history is none of this program's", recording));
    machine_->restore(*decoded);
}

void Replay::next() {
    if (!as_input([&] { return recording_->next(packet_); }))
        throw BadInput(
            fmt::format("linkdig: error: {}: has {} packets, and all have been drawn", path_, packets()));
    ++at_;
}

void Replay::skip_to(std::uint64_t number) {
    if (number >= packets())
        throw BadInput(fmt::format("linkdig: error: {}: has {} packets; expected 0 to {}", path_, packets(),
                                   packets() - std::min<std::uint64_t>(packets(), 1)));
    // Without levels of detail and wakes the machine remembers nothing, and there is nothing to be drawn for it.
    const bool remembers = !opened_.database.details.empty();
    while (at_ < number) {
        next();
        if (remembers || !packet_.wakes.empty()) draw_packet();
    }
}

const FramePacket& Replay::draw() {
    next();
    draw_packet();
    return packet_;
}

void Replay::draw_packet() {
    const FrameReport& report = machine_->frame(packet_);
    if (!report.errors.empty())
        throw BadInput(
            fmt::format("linkdig: error: {}: packet {}: {}", path_, at_ - 1, fmt::join(report.errors, "; ")));
}

void Replay::save_state(const std::string& path) {
    next();
    RecordingWriter file(path, recording_->header(), ig::encode_history(machine_->history()));
    file.write(packet_);
    file.close();
}

} // namespace linkdig::tools
