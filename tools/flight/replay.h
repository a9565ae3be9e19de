#pragma once
/// A recording's packets, drawn again.

#include "host/packet/recording.h"
#include "ig/machine/machine.h"
#include "tools/flight/open_database.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace linkdig::tools {

class Replay {
public:
    /// `database`: a path, or empty for the recording's own. Throws BadInput if the recording is damaged, or the database is
    /// not the one that it was made with.
    Replay(const std::string& recording, const std::string& database, const ig::Configuration& configuration);

    /// Goes to packet `number`, from 0: what the image generator carries from frame to frame is then as if all before had
    /// been drawn. Throws BadInput if there is none.
    void skip_to(std::uint64_t number);
    /// Draws the next packet. Throws BadInput if the machine refuses it, or if there is none.
    const FramePacket& draw();
    /// Writes the next packet, and the history before it, as a saved state. Throws as RecordingWriter does.
    void save_state(const std::string& path);

    std::uint64_t packets() const { return frame_numbers_.size(); } ///< of the whole recording
    /// That packet `number`, from 0, carries: a recording that was begun in mid-flight does not begin with frame 0.
    std::uint64_t frame_number(std::uint64_t number) const { return frame_numbers_[number]; }
    ig::Machine& machine() { return *machine_; }
    const RecordingHeader& header() const { return recording_->header(); }
    const ig::Configuration& configuration() const { return configuration_; }

private:
    void draw_packet(); ///< the one that was read last
    void next();

    std::string path_;
    ig::Configuration configuration_;
    std::unique_ptr<RecordingReader> recording_;
    OpenedDatabase opened_;
    std::unique_ptr<ig::Machine> machine_;
    FramePacket packet_;
    std::vector<std::uint64_t> frame_numbers_; ///< of all packets
    std::uint64_t at_ = 0;                     ///< packets read so far
};

} // namespace linkdig::tools
