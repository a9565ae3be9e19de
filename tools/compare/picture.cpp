#include "tools/compare/picture.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstring>
#include <xxhash.h>

namespace linkdig::compare {
namespace {

template <class Number>
Number sample_at(const Picture& picture, std::size_t sample) {
    Number number;
    std::memcpy(&number, picture.bytes.data() + sample * sizeof(Number), sizeof(Number));
    return number;
}

template <class Number>
void scale_row(const Picture& picture, std::uint32_t row, double scale, double* levels) {
    const std::uint8_t* from = picture.bytes.data() + row * picture.row_bytes();
    const std::size_t samples = std::size_t{picture.width} * picture.channels;
    for (std::size_t k = 0; k < samples; ++k) {
        Number number;
        std::memcpy(&number, from + k * sizeof(Number), sizeof(Number));
        levels[k] = static_cast<double>(number) * scale;
    }
}

std::string sample_text(const Picture& picture, std::size_t sample) {
    switch (picture.sample) {
    case Sample::u8:
        return fmt::format("{}", picture.bytes[sample]);
    case Sample::u16:
        return fmt::format("{}", sample_at<std::uint16_t>(picture, sample));
    case Sample::u32:
        return fmt::format("{}", sample_at<std::uint32_t>(picture, sample));
    default:
        return fmt::format("{}", sample_at<float>(picture, sample));
    }
}

} // namespace

void row_levels(const Picture& picture, std::uint32_t row, double* levels) {
    switch (picture.sample) {
    case Sample::u8:
        return scale_row<std::uint8_t>(picture, row, 1.0, levels);
    case Sample::u16: // 257 u16 steps are exactly one of u8: a picture saved at either depth is the same
        scale_row<std::uint16_t>(picture, row, 1.0, levels);
        for (std::size_t k = 0; k < std::size_t{picture.width} * picture.channels; ++k)
            levels[k] /= 257.0;
        return;
    case Sample::u32:
        return scale_row<std::uint32_t>(picture, row, 1.0, levels);
    case Sample::f32:
        return scale_row<float>(picture, row, 255.0, levels);
    }
}

std::string pixel_text(const Picture& picture, std::uint32_t column, std::uint32_t row) {
    std::vector<std::string> samples;
    const std::size_t first = (std::size_t{row} * picture.width + column) * picture.channels;
    for (std::uint32_t k = 0; k < picture.channels; ++k)
        samples.push_back(sample_text(picture, first + k));
    return fmt::format("({})", fmt::join(samples, " "));
}

std::string shape_text(const Picture& picture) {
    return fmt::format("{} x {}, {} channel{} {}, {}", picture.width, picture.height, picture.channels,
                       picture.channels == 1 ? "" : "s", fmt::join(picture.channel_names, ","),
                       picture.depth);
}

bool same_shape(const Picture& a, const Picture& b) {
    return a.width == b.width && a.height == b.height && a.channels == b.channels &&
           a.names_things() == b.names_things();
}

std::uint32_t number_at(const Picture& picture, std::size_t pixel) {
    return sample_at<std::uint32_t>(picture, pixel * picture.channels);
}

std::uint64_t picture_hash(const Picture& picture) {
    const std::uint32_t shape[] = {picture.width, picture.height, picture.channels,
                                   static_cast<std::uint32_t>(picture.sample)};
    const std::uint64_t seed = XXH64(shape, sizeof shape, 0);
    return XXH64(picture.bytes.data(), picture.bytes.size(), seed);
}

} // namespace linkdig::compare
