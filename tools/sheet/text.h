#pragma once
/// Text on pictures: DejaVu, drawn by OpenImageIO.

#include "ig/video/line.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace linkdig::tools {

/// White letters on nothing: the printable ASCII characters ' ' to '~', `columns` to a row, in cells of equal
/// size.
struct GlyphSheet {
    static constexpr int first = ' ';
    static constexpr int last = '~';
    static constexpr int columns = 16;
    static constexpr int rows = (last - first + columns) / columns;
    int cell_width = 0;  ///< pixels: the font is monospaced, so this is also the step from letter to letter
    int cell_height = 0; ///< pixels: the step from line to line
    std::vector<std::uint32_t>
        pixels; ///< columns * cell_width by rows * cell_height; memory order R, G, B, A

    int width() const { return columns * cell_width; }
    int height() const { return rows * cell_height; }
};

/// The sheet of DejaVu Sans Mono at `size_px` pixels (8 to 64). Throws std::runtime_error, naming the font
/// and its package, if the font is not found.
GlyphSheet glyph_sheet(int size_px);

/// Writes a line of white text on a darkened ground over the foot of a picture; what does not fit or is not printable ASCII is left
/// out.
void write_over(ig::VideoFrame& picture, std::string_view text, const GlyphSheet& glyphs);

/// Throws likewise unless the fonts that titles need are found: asked before a long flight, not after it.
void require_fonts();

/// OpenImageIO's name of the proportional font.
inline constexpr const char* title_font = "DejaVuSans";

} // namespace linkdig::tools
