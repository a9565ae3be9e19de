#include "tools/flight/progress.h"

#include <fmt/format.h>

#include <cstdio>
#include <unistd.h>

namespace linkdig::tools {

bool stderr_is_terminal() { return isatty(STDERR_FILENO) == 1; }

void Progress::at(std::uint64_t done) {
    const std::uint64_t percent = frames_ == 0 ? 100 : done * 100 / frames_;
    if (!shown_ || percent == percent_) return;
    percent_ = percent;
    fmt::print(stderr, "\rframe {} of {}, {} %", done, frames_, percent);
    std::fflush(stderr);
}

void Progress::finish() {
    if (shown_) fmt::print(stderr, "\r\x1b[K");
}

} // namespace linkdig::tools
