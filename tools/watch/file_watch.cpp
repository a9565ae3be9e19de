#include "tools/watch/file_watch.h"

#include <sys/stat.h>

#include <utility>

namespace linkdig::tools {

FileWatch::Stamp FileWatch::stamp_of(const std::string& path) {
    struct stat found {};
    if (stat(path.c_str(), &found) != 0) return {};
    return {static_cast<std::int64_t>(found.st_mtim.tv_sec) * 1'000'000'000 + found.st_mtim.tv_nsec,
            static_cast<std::uint64_t>(found.st_size), static_cast<std::uint64_t>(found.st_ino)};
}

void FileWatch::set(const std::vector<std::string>& paths) {
    std::map<std::string, Stamp> now;
    for (const std::string& path : paths) {
        const auto before = seen_.find(path);
        now.emplace(path, before == seen_.end() ? stamp_of(path) : before->second);
    }
    seen_ = std::move(now);
}

bool FileWatch::changed() {
    bool any = false;
    for (auto& [path, stamp] : seen_) {
        const Stamp now = stamp_of(path);
        any = any || now != stamp;
        stamp = now;
    }
    return any;
}

} // namespace linkdig::tools
