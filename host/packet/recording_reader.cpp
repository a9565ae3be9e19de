#include "host/packet/packet_bytes.h"
#include "host/packet/recording.h"
#include "host/packet/recording_format.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <filesystem>
#include <stdexcept>
#include <system_error>

namespace linkdig {

namespace {

namespace format = recording_format;
namespace fs = std::filesystem;

std::unique_ptr<std::istream> open(const std::string& path) {
    std::error_code code;
    const fs::file_status status = fs::status(path, code);
    std::string why;
    if (status.type() == fs::file_type::not_found) {
        why = "there is no such file";
    } else if (code) {
        why = code.message();
    } else if (status.type() != fs::file_type::regular) {
        why = "it is not a regular file";
    }
    errno = 0;
    auto file = std::make_unique<std::ifstream>();
    if (why.empty()) {
        file->open(path, std::ios::binary);
        if (!*file) why = std::generic_category().message(errno);
    }
    if (!why.empty())
        throw std::runtime_error(fmt::format("{}: cannot be read as a recording: {}", path, why));
    return file;
}

bool get(std::istream& stream, std::span<std::uint8_t> bytes) {
    stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    return static_cast<std::size_t>(stream.gcount()) == bytes.size();
}

} // namespace

RecordingReader::RecordingReader(const std::string& path) : RecordingReader(open(path), path) {}

RecordingReader::RecordingReader(std::unique_ptr<std::istream> stream, std::string name)
    : stream_(std::move(stream)), name_(std::move(name)) {
    stream_->seekg(0, std::ios::end);
    size_ = static_cast<std::uint64_t>(std::max<std::streamoff>(stream_->tellg(), 0));
    stream_->seekg(0);
    read_header();
    if (!record(history_)) refuse("damaged: it ends before its history");
    read_source();
}

void RecordingReader::read_header() {
    if (size_ == 0) refuse("the file is empty");
    if (size_ < format::header_bytes)
        refuse(fmt::format("cut short: {} bytes, the header alone takes {}", size_, format::header_bytes));
    std::array<std::uint8_t, format::header_bytes> bytes{};
    if (!get(*stream_, bytes)) refuse("its header cannot be read");
    if (!std::equal(format::magic.begin(), format::magic.end(), bytes.begin()))
        refuse("not a recording: it does not begin with \"LINKREC\"");
    if (const auto version = format::load<std::uint32_t>(bytes, 8); version != format::version)
        refuse(fmt::format("format version {}; this program reads version {}", version, format::version));
    if (format::load<std::uint64_t>(bytes, 32) != format::hash(std::span(bytes).first(32)))
        refuse("damaged: the header's hash does not fit");
    header_.database_id = format::load<std::uint64_t>(bytes, 16);
    header_.update_rate_hz = std::bit_cast<double>(format::load<std::uint64_t>(bytes, 24));
    if (format::load<std::uint32_t>(bytes, 12) != 0 ||
        !(header_.update_rate_hz > 0.0 && header_.update_rate_hz <= format::max_update_rate_hz))
        refuse("damaged: the header's values are out of range");
}

/// The database's path stands before the history.
void RecordingReader::read_source() {
    const std::size_t length = history_.size() < 4 ? 0 : format::load<std::uint32_t>(history_, 0);
    if (history_.size() < 4 || length > format::most_path_bytes || length > history_.size() - 4) {
        records_ = 0;
        refuse("damaged: the database's path is longer than its record");
    }
    const auto path = history_.begin() + 4;
    const auto end = path + static_cast<std::ptrdiff_t>(length);
    header_.database.assign(path, end);
    history_.erase(history_.begin(), end);
}

bool RecordingReader::next(FramePacket& packet) {
    if (finished_) return false;
    if (!record(bytes_)) {
        finished_ = true;
        return false;
    }
    PacketResult decoded = decode_packet(bytes_);
    if (!decoded.packet) {
        --records_; // the packet that is refused, not the one after
        refuse(decoded.error);
    }
    packet = std::move(*decoded.packet);
    return true;
}

bool RecordingReader::record(std::vector<std::uint8_t>& bytes) {
    std::array<std::uint8_t, format::record_header_bytes> head{};
    const std::uint64_t left = bytes_left();
    if (left < head.size() || !get(*stream_, head))
        refuse(left == 0 ? "cut short: the end record is missing" : "cut short");
    const auto length = format::load<std::uint64_t>(head, 0);
    const auto hash = format::load<std::uint64_t>(head, 8);
    if (length == format::end_length) {
        if (hash != format::record_hash(records_, length, {}))
            refuse("damaged: the end record's hash does not fit");
        if (bytes_left() != 0) refuse("damaged: bytes follow the end record");
        return false;
    }
    if (length > bytes_left())
        refuse(fmt::format("cut short: {} bytes are promised, {} are there", length, bytes_left()));
    bytes.resize(length);
    if (!get(*stream_, bytes)) refuse("it cannot be read");
    if (hash != format::record_hash(records_, length, bytes)) refuse("damaged: its hash does not fit");
    ++records_;
    return true;
}

std::uint64_t RecordingReader::bytes_left() {
    const auto at = static_cast<std::uint64_t>(std::max<std::streamoff>(stream_->tellg(), 0));
    return at < size_ ? size_ - at : 0;
}

void RecordingReader::refuse(const std::string& why) {
    finished_ = true;
    if (records_ == 0)
        throw std::runtime_error(fmt::format("{}: cannot be read as a recording: {}", name_, why));
    throw std::runtime_error(fmt::format("{}: packet {}: {}", name_, records_, why));
}

} // namespace linkdig
