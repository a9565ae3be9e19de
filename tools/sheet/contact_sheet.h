#pragma once
/// A contact sheet: pictures on one page, each with its title; of a flight twelve.

#include "ig/video/line.h"

#include <array>
#include <cstdint>
#include <memory>
#include <string>

namespace linkdig::tools {

inline constexpr std::uint32_t sheet_columns = 4;
inline constexpr std::uint32_t sheet_rows = 3;
inline constexpr std::uint32_t sheet_pictures = sheet_columns * sheet_rows;

/// The frames of a flight of `frames` frames that stand on the sheet: evenly spaced, the first and the last
/// among them. A flight of fewer than twelve frames shows some twice.
std::array<std::uint64_t, sheet_pictures> sheet_frames(std::uint64_t frames);

class ContactSheet {
public:
    /// `heading` stands over the pictures, which are `width` x `height` pixels where they come from. 1 row to 100.
    ContactSheet(const std::string& heading, std::uint32_t width, std::uint32_t height,
                 std::uint32_t rows = sheet_rows);
    ~ContactSheet();
    ContactSheet(const ContactSheet&) = delete;
    ContactSheet& operator=(const ContactSheet&) = delete;

    /// Puts a picture and its title on a place, from 0 on, row by row.
    void place(std::uint32_t place, const ig::VideoFrame& picture, const std::string& title);
    /// Writes the sheet as PNG. Throws std::runtime_error, naming the file, if it cannot.
    void write(const std::string& path) const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace linkdig::tools
