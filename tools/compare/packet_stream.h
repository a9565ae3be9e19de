#pragma once
/// Frame packets one after the other, from a recording or from text with a packet a line.

#include "host/packet/frame_packet.h"
#include "host/packet/recording.h"

#include <fstream>
#include <memory>
#include <span>
#include <string>

namespace linkdig::compare {

class PacketStream {
public:
    /// Throws tools::BadInput, naming path and reason, as next() does.
    explicit PacketStream(const std::string& path);
    bool next(FramePacket& packet);
    /// Of the database that the packets' indices refer to; 0: not known.
    std::uint64_t database_id() const { return database_id_; }
    /// What the machine that drew the recording remembered before it (ig/machine/history_bytes.h). Text has none: it
    /// begins with a machine that has drawn nothing, unless it is made a recording again.
    std::span<const std::uint8_t> history() const;

private:
    bool next_line(FramePacket& packet);

    std::string path_;
    std::unique_ptr<RecordingReader> reader_; ///< null: text
    std::ifstream text_;
    std::uint64_t line_ = 0;
    std::uint64_t database_id_ = 0;
};

/// Does the file begin as a recording does?
bool has_recording_magic(const std::string& path);

} // namespace linkdig::compare
