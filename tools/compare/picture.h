#pragma once
/// A frame as numbers, whatever file it came from.

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace linkdig::compare {

/// How a sample is held in memory. Half floats are held as floats: that loses nothing.
enum class Sample : std::uint8_t { u8, u16, u32, f32 };

/// Rows from the top, pixels from the left, channels interleaved.
struct Picture {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::uint32_t channels = 0;
    Sample sample = Sample::u8;
    std::string depth;                      ///< as the file has it: "uint8", "half" ...
    std::vector<std::string> channel_names; ///< as many as channels
    std::vector<std::uint8_t> bytes;        ///< width * height * channels samples

    std::size_t pixels() const { return std::size_t{width} * height; }
    std::size_t row_bytes() const { return bytes.size() / (height == 0 ? 1 : height); }
    /// Whole numbers that name something (lists, objects, faces, ranks): equal or not, never near.
    bool names_things() const { return sample == Sample::u32; }
};

/// One row's samples as levels: 255 is full intensity at every depth, so that one tolerance fits all. Numbers
/// that name something stay what they are. `levels` holds width * channels values.
void row_levels(const Picture& picture, std::uint32_t row, double* levels);

/// The pixel's samples as the file has them: "(142 148 152)", "(0.5)".
std::string pixel_text(const Picture& picture, std::uint32_t column, std::uint32_t row);

/// "640 x 480, 3 channels R,G,B, uint8".
std::string shape_text(const Picture& picture);

/// Same size and same channels?
bool same_shape(const Picture& a, const Picture& b);

/// The number in channel 0 of a pixel of a picture that names things.
std::uint32_t number_at(const Picture& picture, std::size_t pixel);

/// xxHash (XXH64) of shape and samples. The same picture in another kind of file has the same hash.
std::uint64_t picture_hash(const Picture& picture);

} // namespace linkdig::compare
