#pragma once
/// Pictures and planes as files, through OpenImageIO. Files repeat byte for byte: they carry no time of
/// writing.

#include "ig/video/line.h"

#include <cstdint>
#include <span>
#include <string>

namespace linkdig::ig {

/// Writes the colour picture as an 8-bit RGB PNG. Throws std::runtime_error, naming the file, if it cannot.
void write_png(const std::string& path, const VideoFrame& picture);

/// Writes one channel of floats (32 bits, channel "Y") as OpenEXR; values.size() == width * height. Throws
/// likewise.
void write_exr(const std::string& path, std::uint32_t width, std::uint32_t height,
               std::span<const float> values);

/// Writes one channel of numbers (32 bits, channel `name`) as OpenEXR; values.size() == width * height.
/// Throws likewise.
void write_exr(const std::string& path, const char* name, std::uint32_t width, std::uint32_t height,
               std::span<const std::uint32_t> values);

} // namespace linkdig::ig
