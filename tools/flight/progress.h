#pragma once
/// A line on stderr that says how far long work is.

#include <cstdint>

namespace linkdig::tools {

/// Is stderr a terminal? Elsewhere a progress line would only fill a log.
bool stderr_is_terminal();

class Progress {
public:
    Progress(bool shown, std::uint64_t frames) : shown_(shown), frames_(frames) {}
    /// `done` frames of all are done. Rewrites the line once per percent.
    void at(std::uint64_t done);
    /// Takes the line away.
    void finish();

private:
    bool shown_;
    std::uint64_t frames_;
    std::uint64_t percent_ = ~std::uint64_t{0};
};

} // namespace linkdig::tools
