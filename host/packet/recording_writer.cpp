#include "host/packet/packet_bytes.h"
#include "host/packet/recording.h"
#include "host/packet/recording_format.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <stdexcept>
#include <system_error>

namespace linkdig {

namespace {

namespace format = recording_format;

[[noreturn]] void refuse(const std::string& path, const std::string& why) {
    throw std::runtime_error(fmt::format("cannot write {}: {}", path, why));
}

std::string last_error() { return std::generic_category().message(errno); }

std::array<std::uint8_t, format::header_bytes> header_of(const RecordingHeader& header) {
    std::array<std::uint8_t, format::header_bytes> bytes{};
    std::copy(format::magic.begin(), format::magic.end(), bytes.begin());
    format::store(bytes, 8, format::version);
    format::store(bytes, 16, header.database_id);
    format::store(bytes, 24, std::bit_cast<std::uint64_t>(header.update_rate_hz));
    format::store(bytes, 32, format::hash(std::span(bytes).first(32)));
    return bytes;
}

} // namespace

RecordingWriter::RecordingWriter(const std::string& path, const RecordingHeader& header,
                                 std::span<const std::uint8_t> history)
    : path_(path) {
    if (!(header.update_rate_hz > 0.0 && header.update_rate_hz <= format::max_update_rate_hz))
        refuse(path_, fmt::format("the update rate is {} Hz; expected more than 0 and at most {}",
                                  header.update_rate_hz, format::max_update_rate_hz));
    errno = 0;
    file_.open(path, std::ios::binary | std::ios::trunc);
    if (!file_) refuse(path_, last_error());
    if (header.database.size() > format::most_path_bytes) refuse(path_, "the database's path is too long");
    put(header_of(header));
    std::vector<std::uint8_t> first(4);
    format::store(first, 0, static_cast<std::uint32_t>(header.database.size()));
    first.insert(first.end(), header.database.begin(), header.database.end());
    first.insert(first.end(), history.begin(), history.end());
    record(first);
}

RecordingWriter::~RecordingWriter() {
    try {
        close();
    } catch (const std::runtime_error&) { // NOLINT(bugprone-empty-catch): the docstring says so
    }
}

void RecordingWriter::write(const FramePacket& packet) {
    if (!file_.is_open()) refuse(path_, "the recording is closed");
    try {
        record(encode_packet(packet));
    } catch (const std::length_error& too_long) {
        refuse(path_, too_long.what());
    }
}

void RecordingWriter::close() {
    if (!file_.is_open()) return;
    std::array<std::uint8_t, format::record_header_bytes> end{};
    format::store(end, 0, format::end_length);
    format::store(end, 8, format::record_hash(records_, format::end_length, {}));
    put(end);
    errno = 0;
    file_.close();
    if (!file_) refuse(path_, last_error());
}

void RecordingWriter::record(std::span<const std::uint8_t> bytes) {
    std::array<std::uint8_t, format::record_header_bytes> head{};
    format::store(head, 0, std::uint64_t{bytes.size()});
    format::store(head, 8, format::record_hash(records_, bytes.size(), bytes));
    put(head);
    put(bytes);
    ++records_;
}

void RecordingWriter::put(std::span<const std::uint8_t> bytes) {
    errno = 0;
    file_.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    if (!file_) {
        const std::string why = last_error();
        file_.close();
        refuse(path_, why);
    }
}

} // namespace linkdig
