#include "ig/sink/png_sink.h"

#include "ig/sink/image_file.h"

#include <fmt/format.h>

#include <utility>

namespace linkdig::ig {

PngSink::PngSink(std::string folder, std::string stem) : folder_(std::move(folder)), stem_(std::move(stem)) {}

std::string PngSink::path(std::uint64_t frame) const {
    return fmt::format("{}/{}_{:06}.png", folder_, stem_, frame);
}

void PngSink::put(std::uint64_t frame, const VideoFrame& picture) { write_png(path(frame), picture); }

} // namespace linkdig::ig
