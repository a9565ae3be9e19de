#include "tools/compare/read_picture.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <zlib.h>

namespace linkdig::compare {
namespace {

using OIIO::TypeDesc;

constexpr std::uint8_t png_signature[] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};

std::uint32_t big_endian(const std::uint8_t* at) {
    return static_cast<std::uint32_t>(at[0]) << 24U | static_cast<std::uint32_t>(at[1]) << 16U |
           static_cast<std::uint32_t>(at[2]) << 8U | at[3];
}

struct Held {
    Sample sample;
    TypeDesc type;
};

/// How samples of a file's format are held.
Held held_as(const TypeDesc& format) {
    switch (format.basetype) {
    case TypeDesc::UINT8:
        return {Sample::u8, TypeDesc::UINT8};
    case TypeDesc::UINT16:
        return {Sample::u16, TypeDesc::UINT16};
    case TypeDesc::UINT32:
        return {Sample::u32, TypeDesc::UINT32};
    default:
        return {Sample::f32, TypeDesc::FLOAT};
    }
}

std::string first_line(std::string text) {
    text.erase(std::min(text.find('\n'), text.size()));
    return text.empty() ? "no reason given" : text;
}

ReadPicture refused(const std::string& path, const std::string& why) {
    return {std::nullopt, fmt::format("{}: cannot be read: {}", path, why)};
}

ReadPicture samples_of(OIIO::ImageInput& input, const std::string& path) {
    const OIIO::ImageSpec& spec = input.spec();
    if (spec.width <= 0 || spec.height <= 0 || spec.depth > 1 || spec.nchannels <= 0)
        return refused(path, "it holds no flat picture");
    if (static_cast<std::uint64_t>(spec.width) * static_cast<std::uint64_t>(spec.height) > max_frame_pixels)
        return refused(path, fmt::format("it claims {} x {} pixels; expected at most {} million", spec.width,
                                         spec.height, max_frame_pixels / 1'000'000));
    Picture picture;
    const Held held = held_as(spec.format);
    picture.width = static_cast<std::uint32_t>(spec.width);
    picture.height = static_cast<std::uint32_t>(spec.height);
    picture.channels = static_cast<std::uint32_t>(spec.nchannels);
    picture.sample = held.sample;
    picture.depth = spec.format.c_str();
    picture.channel_names = spec.channelnames;
    picture.bytes.resize(picture.pixels() * picture.channels * held.type.size());
    if (!input.read_image(0, 0, 0, spec.nchannels, held.type, picture.bytes.data()))
        return refused(path, first_line(input.geterror()));
    return {std::move(picture), ""};
}

} // namespace

FileBytes read_file(const std::string& path) {
    std::error_code error;
    if (std::filesystem::is_directory(path, error)) return {{}, path + ": is a folder; expected a picture"};
    FILE* file = std::fopen(path.c_str(), "rb");
    if (file == nullptr) return {{}, fmt::format("{}: cannot be read: {}", path, std::strerror(errno))};
    FileBytes read;
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    if (!error) read.bytes.resize(size);
    if (std::fread(read.bytes.data(), 1, read.bytes.size(), file) != read.bytes.size() || error)
        read.error = path + ": cannot be read to its end";
    else if (read.bytes.empty())
        read.error = path + ": is empty; expected a picture";
    std::fclose(file);
    return read;
}

bool is_whole_png(const std::vector<std::uint8_t>& bytes) {
    std::size_t at = sizeof png_signature;
    if (bytes.size() < at || !std::equal(std::begin(png_signature), std::end(png_signature), bytes.begin()))
        return false;
    while (bytes.size() - at >= 12) {
        const std::uint32_t length = big_endian(&bytes[at]);
        if (length > bytes.size() - at - 12) return false;
        const std::uint8_t* const type = &bytes[at + 4];
        if (crc32(0, type, length + 4) != big_endian(type + 4 + length)) return false;
        at += length + std::size_t{12};
        if (std::memcmp(type, "IEND", 4) == 0) return true;
    }
    return false;
}

ReadPicture decode_picture(const std::string& path, std::vector<std::uint8_t>& bytes) {
    OIIO::ImageSpec hints;
    hints["oiio:UnassociatedAlpha"] = 1; // the samples as they stand, not multiplied by alpha
    OIIO::Filesystem::IOMemReader memory(bytes.data(), bytes.size());
    const auto input = OIIO::ImageInput::open(path, &hints, &memory);
    if (input) {
        ReadPicture read = samples_of(*input, path);
        input->close();
        return read;
    }
    const std::string why = OIIO::geterror();
    // Readers that only know files by name say so; the rest has told what is wrong.
    const auto by_name = OIIO::ImageInput::open(path, &hints);
    if (!by_name) {
        OIIO::geterror();
        return refused(path, first_line(why));
    }
    return samples_of(*by_name, path);
}

ReadPicture read_picture(const std::string& path) {
    FileBytes file = read_file(path);
    if (!file.error.empty()) return {std::nullopt, file.error};
    return decode_picture(path, file.bytes);
}

} // namespace linkdig::compare
