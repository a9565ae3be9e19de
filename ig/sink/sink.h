#pragma once
/// Where a picture goes when the machine has drawn it.

#include "ig/video/line.h"

#include <cstdint>

namespace linkdig::ig {

class Sink {
public:
    virtual ~Sink() = default;
    /// Takes one frame's picture. Calls for different frames may come at the same time from different
    /// threads, and in any order. Throws std::runtime_error, naming what was tried, if the picture cannot be
    /// kept.
    virtual void put(std::uint64_t frame, const VideoFrame& picture) = 0;
};

/// Keeps nothing: for measuring everything but the files.
class NullSink final : public Sink {
public:
    void put(std::uint64_t, const VideoFrame&) override {}
};

} // namespace linkdig::ig
