#include "tools/compare/recording.h"

#include "ig/machine/history_bytes.h"
#include "ig/machine/machine.h"
#include "tools/compare/packet_stream.h"
#include "tools/flight/bad_input.h"
#include "tools/flight/planes.h"

#include <fmt/format.h>

#include <cassert>
#include <filesystem>

namespace linkdig::compare {

using tools::BadInput;

struct Recording::State {
    State(const std::string& of, const FramesOf& with)
        : path(of), frames_of(with), stream(of), machine(*with.database, with.configuration) {
        machine.draw_planes(false, true);
        const auto history = ig::decode_history(stream.history());
        if (!history) throw BadInput("linkdig: error: " + path + ": its history is none of this program's");
        // Under a database with other details the levels held mean nothing: ranges alone decide.
        if (history->held_level.size() == with.database->details.size()) machine.restore(*history);
    }
    std::string path;
    FramesOf frames_of;
    PacketStream stream;
    ig::Machine machine;
    FramePacket packet;
    ig::History before;     ///< the machine's, before the last packet
    std::uint64_t next = 0; ///< number of the packet that the stream gives next
    std::string refusal;    ///< of the last packet
};

bool is_recording(const std::string& path) {
    const auto ending = std::filesystem::path(path).extension();
    return ending == ".jsonl" || ending == ".json" || has_recording_magic(path);
}

Recording::Recording(const std::string& path, const FramesOf& frames_of) {
    if (frames_of.database == nullptr)
        throw BadInput("linkdig: error: " + path +
                       ": a recording holds no faces; expected --database FILE to draw it with");
    state_ = std::make_unique<State>(path, frames_of);
}

Recording::~Recording() = default;

std::vector<RecordedFrame> Recording::frames() const {
    std::vector<RecordedFrame> frames;
    PacketStream stream(state_->path);
    FramePacket packet;
    std::uint64_t pass = 0;
    std::uint64_t last = 0;
    for (std::uint64_t number = 0; stream.next(packet); ++number) {
        if (number > 0 && packet.frame <= last) ++pass;
        last = packet.frame;
        for (std::uint32_t channel = 0; channel < packet.channels.size(); ++channel)
            if (packet.channels[channel].on) frames.push_back({packet.frame, pass, number, channel});
    }
    return frames;
}

std::string Recording::go_to(std::uint64_t packet) {
    State& s = *state_;
    assert(packet + 1 >= s.next);
    while (s.next <= packet) {
        if (!s.stream.next(s.packet)) return "the recording has ended";
        ++s.next;
        // Comparing two databases, each recording is drawn with the one it is given.
        s.packet.database_id = 0;
        s.before = s.machine.history();
        const FrameReport& report = s.machine.frame(s.packet);
        s.refusal = report.errors.empty() ? "" : report.errors.front();
    }
    return s.refusal;
}

const FramePacket& Recording::packet() const { return state_->packet; }

const ig::History& Recording::history_before() const { return state_->before; }

Picture Recording::picture(std::uint32_t channel) const {
    return picture_of(state_->machine.picture(channel));
}

Ids Recording::ids(std::uint32_t channel) const {
    const auto plane = [&](ig::Plane which) {
        return tools::numbers(which, *state_->frames_of.database, state_->machine, channel);
    };
    return {plane(ig::Plane::list), plane(ig::Plane::object), plane(ig::Plane::face)};
}

const FramesOf& Recording::frames_of() const { return state_->frames_of; }

Picture picture_of(const ig::VideoFrame& frame) {
    Picture picture;
    picture.width = frame.width;
    picture.height = frame.height;
    picture.channels = 3;
    picture.depth = "uint8";
    picture.channel_names = {"R", "G", "B"};
    picture.bytes.resize(frame.pixels.size() * 3);
    for (std::size_t k = 0; k < frame.pixels.size(); ++k)
        for (std::size_t c = 0; c < 3; ++c)
            picture.bytes[3 * k + c] = static_cast<std::uint8_t>(frame.pixels[k] >> (8 * c));
    return picture;
}

} // namespace linkdig::compare
