#include "ig/sink/image_file.h"

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <cassert>
#include <stdexcept>

namespace linkdig::ig {
namespace {

/// A layer of samples in memory and how the file shall hold it.
struct Samples {
    OIIO::ImageSpec spec;
    OIIO::TypeDesc type;
    const void* data;
    OIIO::stride_t stride; ///< bytes from pixel to pixel
};

void write_file(const std::string& path, Samples samples) {
    // OpenImageIO stamps the time of writing where none is given: a fixed one keeps files equal from run to
    // run.
    samples.spec.attribute("DateTime", "1979:01:01 00:00:00");
    const auto output = OIIO::ImageOutput::create(path);
    if (!output) throw std::runtime_error(fmt::format("{}: cannot be written: {}", path, OIIO::geterror()));
    const bool written = output->open(path, samples.spec) &&
                         output->write_image(samples.type, samples.data, samples.stride) && output->close();
    if (!written)
        throw std::runtime_error(fmt::format("{}: cannot be written: {}", path, output->geterror()));
}

OIIO::ImageSpec plane_spec(std::uint32_t width, std::uint32_t height, const char* channel,
                           const OIIO::TypeDesc& type) {
    OIIO::ImageSpec spec(static_cast<int>(width), static_cast<int>(height), 1, type);
    spec.channelnames = {channel};
    spec.attribute("compression", "zip");
    return spec;
}

} // namespace

void write_png(const std::string& path, const VideoFrame& picture) {
    assert(picture.pixels.size() == std::size_t{picture.width} * picture.height);
    OIIO::ImageSpec spec(static_cast<int>(picture.width), static_cast<int>(picture.height), 3,
                         OIIO::TypeDesc::UINT8);
    // Level 1: files a third larger than the default's, written several times as fast.
    spec.attribute("png:compressionLevel", 1);
    write_file(path, {spec, OIIO::TypeDesc::UINT8, picture.pixels.data(), sizeof(std::uint32_t)});
}

void write_exr(const std::string& path, std::uint32_t width, std::uint32_t height,
               std::span<const float> values) {
    assert(values.size() == std::size_t{width} * height);
    write_file(path, {plane_spec(width, height, "Y", OIIO::TypeDesc::FLOAT), OIIO::TypeDesc::FLOAT,
                      values.data(), OIIO::AutoStride});
}

void write_exr(const std::string& path, const char* name, std::uint32_t width, std::uint32_t height,
               std::span<const std::uint32_t> values) {
    assert(values.size() == std::size_t{width} * height);
    write_file(path, {plane_spec(width, height, name, OIIO::TypeDesc::UINT32), OIIO::TypeDesc::UINT32,
                      values.data(), OIIO::AutoStride});
}

} // namespace linkdig::ig
