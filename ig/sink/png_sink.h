#pragma once
/// One PNG file per frame: FOLDER/STEM_000000.png.

#include "ig/sink/sink.h"

#include <string>

namespace linkdig::ig {

class PngSink final : public Sink {
public:
    /// The folder must exist.
    explicit PngSink(std::string folder, std::string stem = "frame");
    void put(std::uint64_t frame, const VideoFrame& picture) override;
    std::string path(std::uint64_t frame) const;

private:
    std::string folder_;
    std::string stem_;
};

} // namespace linkdig::ig
