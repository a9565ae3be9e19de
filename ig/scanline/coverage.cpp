#include "ig/scanline/coverage.h"

#include <algorithm>
#include <cstdlib>

namespace linkdig::ig {

namespace {

constexpr auto whole = static_cast<std::int32_t>(whole_pixel);

/// Where the edge crosses the border above `line`, 1/256 pixel.
std::int32_t at_border(const OutlineEdge& edge, std::int32_t line) {
    const auto steps = static_cast<std::uint64_t>(line - edge.first_border);
    const std::uint64_t position =
        static_cast<std::uint64_t>(edge.start) + steps * static_cast<std::uint64_t>(edge.slope);
    return static_cast<std::int32_t>(static_cast<std::int64_t>(position) >> outline_bits);
}

/// How far across the line a piece has got at the left border of an element between its ends: rise * run / length, rounded
/// to the nearest 1/256, upwards on the line. Numerator and denominator are whole numbers below 2^35, so the double's
/// quotient is never rounded across a whole number, and is exact.
std::int32_t passed_at(const EdgePiece& piece, std::int32_t element) {
    const double length = piece.right - piece.left;
    const double twice = 2.0 * (element * 256.0 - piece.left) * piece.rise + length;
    return twice >= 0.0 ? static_cast<std::int32_t>(twice / (2.0 * length))
                        : static_cast<std::int32_t>((2.0 * length - 1.0 - twice) / (2.0 * length));
}

/// False if the edge does not touch the line, or only along its border.
bool piece_of(const OutlineEdge& edge, std::int32_t line, EdgePiece& piece) {
    const std::int32_t top = line * 256;
    const std::int32_t bottom = top + 256;
    if (edge.lower_line <= top || edge.upper_line >= bottom) return false;
    const bool begins = edge.upper_line >= top;
    const bool ends = edge.lower_line <= bottom;
    const std::int32_t upper_x = begins ? edge.upper_element : at_border(edge, line);
    const std::int32_t lower_x = ends ? edge.lower_element : at_border(edge, line + 1);
    const std::int32_t height = (ends ? edge.lower_line - top : 256) - (begins ? edge.upper_line - top : 0);
    piece.left = std::min(upper_x, lower_x);
    piece.right = std::max(upper_x, lower_x);
    piece.rise = upper_x <= lower_x ? height : -height;
    piece.height = height;
    piece.sign = edge.sign;
    return height != 0;
}

/// Adds what a piece contributes to the elements of `part`, none of which lies left of it unless it begins at 0.
void add_piece(const EdgePiece& piece, const PartlyCovered& part, std::int32_t* areas) {
    const std::int32_t last = piece.last();
    std::int32_t element = piece.first();
    if (element >= part.end) return;
    std::int32_t* area = areas + part.first;
    std::int32_t passed = 0;
    std::int32_t x = piece.left & 255;
    if (element < part.begin) {
        passed = last < part.begin ? piece.height : passed_at(piece, part.begin);
        element = part.begin;
        x = 0;
    } else {
        area += element - part.begin;
    }
    const std::int32_t crossed_end = std::min(last, part.end);
    for (; element < crossed_end; ++element, ++area) {
        const std::int32_t next = passed_at(piece, element + 1);
        *area += piece.sign * (512 * passed + (next - passed) * (256 - x));
        passed = next;
        x = 0;
    }
    if (element == last && element < part.end) {
        *area += piece.sign * (512 * passed + (piece.height - passed) * (512 - x - (piece.right & 255)));
        ++element, ++area;
    }
    const std::int32_t behind = piece.sign * 512 * piece.height;
    for (; element < part.end; ++element, ++area)
        *area += behind;
}

PartlyCovered open_part(std::int32_t begin, std::int32_t end, std::int32_t area, std::int32_t elements,
                        std::vector<std::int32_t>& areas) {
    PartlyCovered part{std::clamp(begin, 0, elements), std::clamp(end, 0, elements), areas.size()};
    if (part.begin < part.end)
        areas.resize(areas.size() + static_cast<std::size_t>(part.end - part.begin), area);
    return part;
}

void clamp_areas(std::vector<std::int32_t>& areas) {
    for (std::int32_t& area : areas)
        area = std::clamp(area, 0, whole);
}

/// Elements that an edge only touches belong to the stretch that is covered wholly.
void widen_whole(LineCoverage& coverage) {
    PartlyCovered& before = coverage.parts[0];
    PartlyCovered& behind = coverage.parts[1];
    const auto area = [&coverage](const PartlyCovered& part, std::int32_t element) {
        return coverage.areas[part.first + static_cast<std::size_t>(element - part.begin)];
    };
    for (; before.begin < before.end && area(before, before.end - 1) == whole; --before.end)
        coverage.whole_begin = before.end - 1;
    for (; behind.begin < behind.end && area(behind, behind.begin) == whole; ++behind.begin, ++behind.first)
        coverage.whole_end = behind.begin + 1;
}

} // namespace

void trace_line(std::span<const OutlineEdge> outline, std::int32_t line, std::int32_t elements,
                OutlineLine& traced) {
    traced.pieces.clear();
    traced.leading = {};
    traced.trailing = {};
    for (const OutlineEdge& edge : outline) {
        EdgePiece& piece = traced.pieces.emplace_back(); // a copy would wait for its parts to be written
        if (piece_of(edge, line, piece)) {
            (edge.sign > 0 ? traced.leading : traced.trailing).add(piece);
        } else {
            traced.pieces.pop_back();
        }
    }
    traced.begin = std::clamp(std::min(traced.leading.begin, traced.trailing.begin), 0, elements);
    traced.end = std::clamp(std::max(traced.leading.end, traced.trailing.end), 0, elements);
}

void cover_line(const OutlineLine& traced, std::int32_t elements, LineCoverage& coverage) {
    const EdgeSide& leading = traced.leading;
    const EdgeSide& trailing = traced.trailing;
    std::vector<std::int32_t>& areas = coverage.areas;
    areas.clear();
    coverage.parts = {};
    coverage.whole_begin = coverage.whole_end = 0;
    if (leading.height == 0) return;
    const bool apart = leading.end <= trailing.begin && 512 * leading.height == whole;
    if (apart) {
        coverage.parts[0] = open_part(leading.begin, leading.end, 0, elements, areas);
        coverage.parts[1] = open_part(trailing.begin, trailing.end, whole, elements, areas);
        coverage.whole_begin = std::clamp(leading.end, 0, elements);
        coverage.whole_end = std::clamp(trailing.begin, 0, elements);
    } else {
        coverage.parts[0] = open_part(traced.begin, traced.end, 0, elements, areas);
    }
    for (const EdgePiece& piece : traced.pieces) {
        const PartlyCovered& part = coverage.parts[apart && piece.sign < 0 ? 1 : 0];
        if (part.begin < part.end) add_piece(piece, part, areas.data());
    }
    clamp_areas(areas);
    if (apart) widen_whole(coverage);
}

} // namespace linkdig::ig
