#include "ig/scanline/coverage.h"

#include <algorithm>
#include <cstdlib>

namespace linkdig::ig {

namespace {

constexpr std::int32_t outline_bits = 40;

/// Where the edge crosses the border above `line`, 1/256 pixel.
std::int32_t at_border(const OutlineEdge& edge, std::int32_t line) {
    const auto steps = static_cast<std::uint64_t>(line - edge.first_border);
    const std::uint64_t position =
        static_cast<std::uint64_t>(edge.start) + steps * static_cast<std::uint64_t>(edge.slope);
    return static_cast<std::int32_t>(static_cast<std::int64_t>(position) >> outline_bits);
}

/// The part of an edge inside one line: from (left, left_y) to (right, right_y), y counted from the line's upper border.
struct Piece {
    std::int32_t left = 0, left_y = 0;
    std::int32_t right = 0, right_y = 0;

    /// Height at which it crosses the border at the left of an element, rounded to the nearest 1/256.
    std::int32_t y_at(std::int32_t element) const {
        const std::int64_t run = right - left;
        const std::int64_t rise = right_y - left_y;
        const std::int64_t twice = 2 * (std::int64_t{element} * 256 - left) * rise + run;
        const std::int64_t quotient = twice >= 0 ? twice / (2 * run) : -((-twice + 2 * run - 1) / (2 * run));
        return left_y + static_cast<std::int32_t>(quotient);
    }
};

/// Adds what an edge that runs from (from_x, from_y) to (to_x, to_y) inside one element contributes.
void add_cell(std::int32_t element, std::int32_t from_x, std::int32_t to_x, std::int32_t from_y,
              std::int32_t to_y, std::int32_t sign, std::vector<CoverageCell>& cells) {
    const std::int32_t height = sign * std::abs(to_y - from_y);
    if (height != 0) cells.push_back({element, height, height * (from_x + to_x)});
}

void add_piece(const Piece& piece, std::int32_t sign, std::int32_t elements,
               std::vector<CoverageCell>& cells) {
    const std::int32_t last = piece.right >> 8;
    std::int32_t element = piece.left >> 8;
    std::int32_t x = piece.left & 255;
    std::int32_t y = piece.left_y;
    if (element < 0) { // left of the picture: all of the line lies to its right
        const std::int32_t y_in = last < 0 ? piece.right_y : piece.y_at(0);
        add_cell(-1, 0, 0, y, y_in, sign, cells);
        if (last < 0) return;
        y = y_in;
        x = 0;
        element = 0;
    }
    for (; element < last && element < elements; ++element) {
        const std::int32_t y_out = piece.y_at(element + 1);
        add_cell(element, x, 256, y, y_out, sign, cells);
        y = y_out;
        x = 0;
    }
    if (element < elements) add_cell(element, x, piece.right & 255, y, piece.right_y, sign, cells);
}

void add_edge(const OutlineEdge& edge, std::int32_t line, std::int32_t elements,
              std::vector<CoverageCell>& cells) {
    const std::int32_t top = line * 256;
    const std::int32_t bottom = top + 256;
    if (edge.lower_line <= top || edge.upper_line >= bottom) return;
    const bool begins = edge.upper_line >= top;
    const bool ends = edge.lower_line <= bottom;
    const std::int32_t upper_x = begins ? edge.upper_element : at_border(edge, line);
    const std::int32_t lower_x = ends ? edge.lower_element : at_border(edge, line + 1);
    const std::int32_t upper_y = begins ? edge.upper_line - top : 0;
    const std::int32_t lower_y = ends ? edge.lower_line - top : 256;
    const Piece piece = upper_x <= lower_x ? Piece{upper_x, upper_y, lower_x, lower_y}
                                           : Piece{lower_x, lower_y, upper_x, upper_y};
    add_piece(piece, edge.sign, elements, cells);
}

void put_run(std::int32_t begin, std::int32_t end, std::int32_t coverage, std::vector<CoverageRun>& runs) {
    if (begin >= end || coverage <= 0) return;
    runs.push_back({begin, end, std::min(static_cast<std::uint32_t>(coverage), whole_pixel)});
}

} // namespace

void cover_line(std::span<const OutlineEdge> outline, std::int32_t line, std::int32_t elements,
                std::vector<CoverageCell>& cells, std::vector<CoverageRun>& runs) {
    cells.clear();
    runs.clear();
    for (const OutlineEdge& edge : outline)
        add_edge(edge, line, elements, cells);
    std::sort(cells.begin(), cells.end(),
              [](const CoverageCell& a, const CoverageCell& b) { return a.element < b.element; });
    std::int32_t cover = 0; // of the edges to the left, of 256
    std::int32_t done = 0;
    for (std::size_t k = 0; k < cells.size();) {
        const std::int32_t element = cells[k].element;
        put_run(done, std::min(element, elements), 512 * cover, runs);
        std::int32_t area = 0;
        for (; k < cells.size() && cells[k].element == element; ++k) {
            cover += cells[k].cover;
            area += cells[k].area;
        }
        if (element >= 0) put_run(element, element + 1, 512 * cover - area, runs);
        done = element + 1;
    }
    put_run(done, elements, 512 * cover, runs);
}

} // namespace linkdig::ig
