#include "host/packet/recording_json.h"

#include "host/packet/json_reader.h"
#include "host/packet/packet_json.h"

#include <fmt/format.h>

#include <cerrno>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <system_error>

namespace linkdig {

namespace {

constexpr std::uint32_t text_version = 1;

std::string digits_of(const std::vector<std::uint8_t>& bytes) {
    return fmt::format("{:02x}", fmt::join(bytes, ""));
}

std::vector<std::uint8_t> bytes_of(const std::string& digits) {
    std::vector<std::uint8_t> bytes(digits.size() / 2);
    bool good = digits.size() % 2 == 0;
    for (std::size_t i = 0; i < bytes.size() && good; ++i) {
        const char* const pair = digits.data() + 2 * i;
        const auto parsed = std::from_chars(pair, pair + 2, bytes[i], 16);
        good = parsed.ec == std::errc{} && parsed.ptr == pair + 2;
    }
    if (!good) throw JsonMistake("history", "expected pairs of hexadecimal digits");
    return bytes;
}

struct HeaderLine {
    RecordingHeader header;
    std::vector<std::uint8_t> history;
};

HeaderLine header_of(const std::string& line) {
    const Json json = parse_json(line);
    JsonReader reader(json, "");
    std::uint32_t version = 0;
    reader.required("linkdig_recording", version);
    if (version != text_version)
        throw JsonMistake("linkdig_recording", fmt::format("expected version {}", text_version));
    HeaderLine made;
    reader.bits("database_id", made.header.database_id);
    reader("update_rate_hz", made.header.update_rate_hz);
    reader("database", made.header.database);
    std::string digits;
    reader("history", digits);
    made.history = bytes_of(digits);
    reader.finish();
    return made;
}

} // namespace

void recording_to_json(RecordingReader& recording, std::ostream& text) {
    Json header = Json::object();
    header["linkdig_recording"] = text_version;
    header["database_id"] = hexadecimal(recording.header().database_id);
    header["update_rate_hz"] = recording.header().update_rate_hz;
    if (!recording.header().database.empty()) header["database"] = recording.header().database;
    header["history"] = digits_of(recording.history());
    text << header.dump() << '\n';
    FramePacket packet;
    while (recording.next(packet))
        text << to_json(packet) << '\n';
    text.flush();
    if (!text) throw std::runtime_error("the recording's text cannot be written");
}

namespace {

/// Throws what json_to_recording does; `path` is left half-written then.
void write_lines(std::istream& text, const std::string& path) {
    std::optional<RecordingWriter> recording;
    std::string line;
    for (std::size_t number = 1; std::getline(text, line); ++number) {
        try {
            if (!recording) {
                const HeaderLine head = header_of(line);
                recording.emplace(path, head.header, head.history);
                continue;
            }
            FramePacket packet;
            read_value(parse_json(line), "", packet);
            recording->write(packet);
        } catch (const JsonMistake& mistake) {
            throw RecordingTextMistake(fmt::format("line {}: {}", number, mistake.what()));
        }
    }
    if (!recording) throw RecordingTextMistake("line 1: missing; expected the recording's header");
    recording->close();
}

/// Calls write(temporary name), then gives the file its name; nothing is left if that throws.
template <typename Write>
void write_whole(const std::string& path, Write write) {
    const std::string temporary = path + ".part";
    std::error_code failed;
    try {
        write(temporary);
    } catch (const std::runtime_error&) {
        std::filesystem::remove(temporary, failed);
        throw;
    }
    std::filesystem::rename(temporary, path, failed);
    if (failed) {
        std::error_code ignored;
        std::filesystem::remove(temporary, ignored);
        throw std::runtime_error(fmt::format("cannot write {}: {}", path, failed.message()));
    }
}

} // namespace

void recording_to_json(RecordingReader& recording, const std::string& path) {
    write_whole(path, [&](const std::string& temporary) {
        errno = 0;
        std::ofstream text(temporary);
        if (!text) throw std::system_error(errno, std::generic_category(), "cannot write " + temporary);
        recording_to_json(recording, text);
    });
}

void json_to_recording(std::istream& text, const std::string& path) {
    write_whole(path, [&](const std::string& temporary) { write_lines(text, temporary); });
}

} // namespace linkdig
