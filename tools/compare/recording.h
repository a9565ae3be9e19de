#pragma once
/// Recordings as frames: each packet is drawn when its turn comes.

#include "host/packet/frame_packet.h"
#include "ig/active/history.h"
#include "ig/configuration.h"
#include "ig/video/line.h"
#include "tools/compare/ids.h"
#include "tools/compare/picture.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace linkdig::compare {

/// What a recording's frames are drawn with.
struct FramesOf {
    const VisualDatabase* database = nullptr; ///< must outlive the recording
    std::uint64_t database_id = 0;
    ig::Configuration configuration;
};

/// Is the file a recording, or text with a frame packet a line (.jsonl, .json)?
bool is_recording(const std::string& path);

struct RecordedFrame {
    std::uint64_t number = 0;
    std::uint64_t pass = 0; ///< how often the numbers began again before it
    std::uint64_t packet = 0;
    std::uint32_t channel = 0;
};

class Recording {
public:
    /// Throws tools::BadInput if there is no database, or the machine's history in it cannot be read.
    Recording(const std::string& path, const FramesOf& frames_of);
    ~Recording();
    Recording(const Recording&) = delete;
    Recording& operator=(const Recording&) = delete;

    /// Every channel that is on, of every packet. Reads the file through; throws tools::BadInput, naming the
    /// packet, if it is damaged.
    std::vector<RecordedFrame> frames() const;

    /// Goes on to a packet and draws it; packets only ascend. Returns why it cannot be drawn, or nothing.
    std::string go_to(std::uint64_t packet);
    const FramePacket& packet() const;            ///< of the last go_to()
    const ig::History& history_before() const;    ///< what the machine remembered before it
    Picture picture(std::uint32_t channel) const; ///< of the last go_to()
    Ids ids(std::uint32_t channel) const;         ///< likewise
    const FramesOf& frames_of() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// 8-bit RGB.
Picture picture_of(const ig::VideoFrame& frame);

} // namespace linkdig::compare
