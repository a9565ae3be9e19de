#pragma once
/// What a frame's file name says: `colour_000010.png` of linkdig render, `frame0001.png` or `shot.12.exr` of
/// others.

#include <compare>
#include <cstdint>
#include <optional>
#include <string>

namespace linkdig::compare {

struct FrameName {
    std::string series;                  ///< the name without number and ending: "colour", "frame"
    std::optional<std::uint64_t> number; ///< the last run of digits of the name
    std::string plane; ///< list, object, face, rank or intensity if the series ends so; else empty: a picture
    std::string prefix; ///< the series without the plane, or without "colour"
};

/// `file` is a name without its folder.
FrameName frame_name(const std::string& file);

/// Do the frames of files with this ending count as pictures (.png, .exr, .tif, .tiff, any case)?
bool is_picture_file(const std::string& file);

} // namespace linkdig::compare
