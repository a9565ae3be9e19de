#pragma once
/// Recordings: the frame packets of a flight, in a file. Replaying one gives the same pictures.
///
/// File, all numbers little-endian:
///   header   0  8  magic            8  4  format version     12  4  reserved, zero
///           16  8  database id     24  8  update rate, Hz (double)
///           32  8  xxHash64 (seed 0) of bytes 0 to 31
///   records, each: 8 length of its bytes, 8 hash, bytes. Record 0: 4 length of the database's path, the path,
///     and the image generator's history, one opaque value, maybe empty; record n is the n-th packet (packet_bytes.h). The hash covers the record's number, its
///     length and its bytes, so that no record can be changed, moved or lost unnoticed.
///   end: a record of length 2^64-1 without bytes. A file without it was cut short.

#include "host/packet/frame_packet.h"

#include <cstdint>
#include <fstream>
#include <istream>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace linkdig {

struct RecordingHeader {
    std::uint64_t database_id =
        0; ///< of the compiled database that the packets' indices refer to; 0: not known
    double update_rate_hz = 60.0; ///< more than 0, at most 10000
    std::string database{};       ///< where it was read from, .toml or .igdb; empty: not known
    bool operator==(const RecordingHeader&) const = default;
};

/// Writes packets as they come: what was written up to a crash can be read.
class RecordingWriter {
public:
    /// Throws std::runtime_error naming path and reason, as all of this class but the destructor does.
    RecordingWriter(const std::string& path, const RecordingHeader& header,
                    std::span<const std::uint8_t> history = {});
    /// Closes what close() did not, without telling errors.
    ~RecordingWriter();
    RecordingWriter(const RecordingWriter&) = delete;
    RecordingWriter& operator=(const RecordingWriter&) = delete;

    void write(const FramePacket& packet);
    /// Writes the end record and closes the file.
    void close();
    std::uint64_t packets() const { return records_ == 0 ? 0 : records_ - 1; }

private:
    void record(std::span<const std::uint8_t> bytes);
    void put(std::span<const std::uint8_t> bytes);

    std::string path_;
    std::ofstream file_;
    std::uint64_t records_ = 0;
};

class RecordingReader {
public:
    /// Reads header and history. Throws std::runtime_error naming path and reason.
    explicit RecordingReader(const std::string& path);
    /// From a seekable stream; `name` stands for the path in messages.
    RecordingReader(std::unique_ptr<std::istream> stream, std::string name);

    const RecordingHeader& header() const { return header_; }
    const std::vector<std::uint8_t>& history() const { return history_; }

    /// The next packet; false after the last. Throws std::runtime_error naming path, packet number (from 1)
    /// and reason if the file is damaged or was cut short there; afterwards there are no more packets.
    bool next(FramePacket& packet);

private:
    void read_header();
    void read_source();
    /// False at the end record.
    bool record(std::vector<std::uint8_t>& bytes);
    std::uint64_t bytes_left();
    [[noreturn]] void refuse(const std::string& why);

    std::unique_ptr<std::istream> stream_;
    std::string name_;
    RecordingHeader header_;
    std::vector<std::uint8_t> history_;
    std::vector<std::uint8_t> bytes_; ///< of the packet before; its capacity is used again
    std::uint64_t size_ = 0;
    std::uint64_t records_ = 0;
    bool finished_ = false;
};

} // namespace linkdig
