#pragma once
/// Pictures from files: PNG, EXR and TIFF through OpenImageIO.

#include "tools/compare/picture.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace linkdig::compare {

struct FileBytes {
    std::vector<std::uint8_t> bytes;
    std::string error; ///< empty: read
};

/// The whole file. Folders, missing and empty files are refused, by name and reason.
FileBytes read_file(const std::string& path);

/// The file's bytes hold one whole picture as far as that can be told without decoding it: for PNG, every
/// chunk is there and has its checksum. False for other kinds.
bool is_whole_png(const std::vector<std::uint8_t>& bytes);

struct ReadPicture {
    std::optional<Picture> picture;
    std::string error; ///< "NAME: why", if there is no picture
};

/// No frame has more pixels: whatever claims to is a damaged file.
inline constexpr std::uint64_t max_frame_pixels = std::uint64_t{1} << 28U;

/// Decodes what read_file() read; `path` tells the kind of file, and stands in messages.
ReadPicture decode_picture(const std::string& path, std::vector<std::uint8_t>& bytes);

/// Both steps.
ReadPicture read_picture(const std::string& path);

} // namespace linkdig::compare
