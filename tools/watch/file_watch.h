#pragma once
/// Have files changed since they were last looked at? By polling: it works on every file system, network ones too.

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace linkdig::tools {

class FileWatch {
public:
    /// Watches exactly these files from now on. One that is watched already keeps what was last seen of it, so that a
    /// change made between two calls is not lost.
    void set(const std::vector<std::string>& paths);
    /// Is any of them another file than at the last look: written, replaced, removed, or there again?
    bool changed();

private:
    /// What tells one state of a file from the next; all zero: it is not there.
    struct Stamp {
        std::int64_t written_ns = 0;
        std::uint64_t size = 0;
        std::uint64_t inode = 0; ///< another one after a save by renaming
        bool operator==(const Stamp&) const = default;
    };
    static Stamp stamp_of(const std::string& path);
    std::map<std::string, Stamp> seen_;
};

} // namespace linkdig::tools
