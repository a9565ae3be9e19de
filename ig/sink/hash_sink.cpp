#include "ig/sink/hash_sink.h"

#include <array>
#include <xxhash.h>

namespace linkdig::ig {

std::uint64_t picture_hash(const VideoFrame& picture) {
    // The size seeds the hash of the pixels: 2 x 8 and 4 x 4 pictures of the same bytes differ.
    const std::array<std::uint32_t, 2> size{picture.width, picture.height};
    const std::uint64_t seed = XXH64(size.data(), sizeof size, 0);
    return XXH64(picture.pixels.data(), picture.pixels.size() * sizeof(std::uint32_t), seed);
}

void HashSink::put(std::uint64_t frame, const VideoFrame& picture) {
    const std::uint64_t hash = picture_hash(picture);
    const std::lock_guard lock(mutex_);
    hashes_[frame] = hash;
}

} // namespace linkdig::ig
