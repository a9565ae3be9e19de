#pragma once
/// Pictures as numbers: equal numbers, equal bytes.

#include "ig/sink/sink.h"

#include <map>
#include <mutex>

namespace linkdig::ig {

/// xxHash (XXH64) of a picture's width, height and pixels, all as little-endian 32-bit words.
std::uint64_t picture_hash(const VideoFrame& picture);

/// Remembers each frame's hash.
class HashSink final : public Sink {
public:
    void put(std::uint64_t frame, const VideoFrame& picture) override;
    /// Hashes by frame number. Call when no put() is under way.
    const std::map<std::uint64_t, std::uint64_t>& hashes() const { return hashes_; }

private:
    std::mutex mutex_;
    std::map<std::uint64_t, std::uint64_t> hashes_;
};

} // namespace linkdig::ig
