#include "tools/compare/packet_stream.h"

#include "host/packet/packet_json.h"
#include "host/packet/recording_format.h"
#include "tools/flight/bad_input.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace linkdig::compare {

using tools::BadInput;

bool has_recording_magic(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::array<char, recording_format::magic.size()> start{};
    file.read(start.data(), start.size());
    return file && std::equal(start.begin(), start.end(), recording_format::magic.begin(),
                              [](char a, std::uint8_t b) { return static_cast<std::uint8_t>(a) == b; });
}

PacketStream::PacketStream(const std::string& path) : path_(path) {
    if (!has_recording_magic(path)) {
        text_.open(path);
        if (!text_) throw BadInput("linkdig: error: " + path + ": cannot be read");
        return;
    }
    try {
        reader_ = std::make_unique<RecordingReader>(path);
        database_id_ = reader_->header().database_id;
    } catch (const std::runtime_error& error) {
        throw BadInput(std::string("linkdig: error: ") + error.what());
    }
}

std::span<const std::uint8_t> PacketStream::history() const {
    return reader_ ? std::span<const std::uint8_t>(reader_->history()) : std::span<const std::uint8_t>{};
}

bool PacketStream::next(FramePacket& packet) {
    if (!reader_) return next_line(packet);
    try {
        return reader_->next(packet);
    } catch (const std::runtime_error& error) {
        throw BadInput(std::string("linkdig: error: ") + error.what());
    }
}

bool PacketStream::next_line(FramePacket& packet) {
    std::string line;
    while (std::getline(text_, line)) {
        ++line_;
        // A recording's text begins with its header; the packets carry the database's number themselves.
        if (line.empty() || (line_ == 1 && line.find("\"linkdig_recording\"") != std::string::npos)) continue;
        PacketResult read = from_json(line);
        if (!read.packet) throw BadInput(fmt::format("{}:{}: error: {}", path_, line_, read.error));
        packet = std::move(*read.packet);
        return true;
    }
    return false;
}

} // namespace linkdig::compare
