#include "tools/fly/recordings.h"

#include <fmt/format.h>

#include <filesystem>

namespace linkdig::tools {

void Recordings::follow(bool on, const Flight& flight) {
    if (on == active()) return;
    if (!on) {
        finish();
        return;
    }
    const std::string path = next_path();
    writer_.emplace(path, flight.recording_header(), flight.history());
    recorded_.push_back({path, 0});
}

std::string Recordings::next_path() const {
    if (recorded_.empty()) return first_path_;
    const std::filesystem::path first(first_path_);
    const std::string name =
        fmt::format("{}-{}{}", first.stem().string(), recorded_.size() + 1, first.extension().string());
    return (first.parent_path() / name).string();
}

void Recordings::write(const FramePacket& packet) {
    if (!writer_) return;
    writer_->write(packet);
    recorded_.back().packets = writer_->packets();
}

const std::vector<Recorded>& Recordings::finish() {
    if (writer_) writer_->close();
    writer_.reset();
    return recorded_;
}

} // namespace linkdig::tools
