#include "tools/compare/side.h"

#include "tools/flight/bad_input.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <tuple>

namespace linkdig::compare {
namespace {

namespace fs = std::filesystem;
using tools::BadInput;

auto order_of(const Entry& entry) {
    return std::tuple(entry.pass, entry.key.number.has_value(), entry.key.number.value_or(0),
                      std::string_view(entry.key.series));
}

void refuse_doubles(const Side& side) {
    for (std::size_t k = 1; k < side.entries.size(); ++k) {
        const Entry& a = side.entries[k - 1];
        const Entry& b = side.entries[k];
        if (order_of(a) == order_of(b))
            throw BadInput(
                fmt::format("linkdig: error: {}: {} and {} are the same frame; expected one file for each",
                            side.path, a.name, b.name));
    }
}

void read_folder(Side& side, bool may_be_empty) {
    std::error_code error;
    for (fs::directory_iterator file(side.path, error), end; !error && file != end; file.increment(error)) {
        const std::string name = file->path().filename().string();
        if (!is_picture_file(name) || name.starts_with('.') || file->is_directory(error)) continue;
        side.entries.push_back({name, file->path().string(), frame_name(name)});
    }
    if (error)
        throw BadInput(fmt::format("linkdig: error: {}: cannot be read: {}", side.path, error.message()));
    if (side.entries.empty() && !may_be_empty)
        throw BadInput(
            fmt::format("linkdig: error: {}: no frames in it; expected .png, .exr or .tif files", side.path));
}

/// Names as files of a golden have them: frame for the first channel, channel_1 for the next.
void read_recording(Side& side) {
    const std::vector<RecordedFrame> frames = side.recording->frames();
    for (const RecordedFrame& frame : frames) {
        Entry entry;
        entry.name = frame.channel == 0 ? fmt::format("frame {}", frame.number)
                                        : fmt::format("frame {} channel {}", frame.number, frame.channel);
        entry.key.series = frame.channel == 0 ? "frame" : fmt::format("channel_{}", frame.channel);
        entry.key.prefix = entry.key.series;
        entry.key.number = frame.number;
        entry.pass = frame.pass;
        entry.packet = frame.packet;
        entry.channel = frame.channel;
        side.entries.push_back(std::move(entry));
    }
    if (side.entries.empty()) throw BadInput("linkdig: error: " + side.path + ": no packets in it");
}

} // namespace

Side open_side(const std::string& path, const FramesOf& frames_of, bool may_be_empty) {
    Side side;
    side.path = path;
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (!fs::exists(status)) throw BadInput("linkdig: error: " + path + ": there is no such file or folder");
    if (fs::is_directory(status)) {
        side.kind = Kind::folder;
        read_folder(side, may_be_empty);
    } else if (is_recording(path)) {
        side.kind = Kind::recording;
        side.recording = std::make_unique<Recording>(path, frames_of);
        read_recording(side);
    } else {
        const std::string name = fs::path(path).filename().string();
        side.entries.push_back({name, path, frame_name(name)});
    }
    std::ranges::stable_sort(side.entries,
                             [](const Entry& a, const Entry& b) { return order_of(a) < order_of(b); });
    refuse_doubles(side);
    return side;
}

const char* kind_text(Kind kind) {
    constexpr const char* texts[] = {"a picture", "a folder of frames", "a recording"};
    return texts[static_cast<std::size_t>(kind)];
}

} // namespace linkdig::compare
