// Lines of a vertical scan become columns, whatever their number and length, and nothing beside them is written.

#include "ig/video/turn_lines.h"

#include "ig/simd/simd_level.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace linkdig::ig {
namespace {

constexpr std::uint32_t untouched = 0xdeadbeef;

/// Line n's element k is n * 1000 + k.
void expect_turned(std::size_t lines, std::size_t elements, std::size_t gap, std::size_t column) {
    const std::size_t length = elements + gap, width = column + lines + 3;
    std::vector<std::uint32_t> pixels(lines * length);
    for (std::size_t k = 0; k < pixels.size(); ++k)
        pixels[k] = static_cast<std::uint32_t>(k / length * 1000 + k % length);
    std::vector<std::uint32_t> picture(width * elements, untouched);
    turn_lines({pixels.data(), length, lines, elements, picture.data() + column, width});
    for (std::size_t k = 0; k < picture.size(); ++k) {
        const std::size_t row = k / width, at = k % width;
        const bool written = at >= column && at < column + lines;
        ASSERT_EQ(picture[k], written ? (at - column) * 1000 + row : untouched) << row << ' ' << at;
    }
}

TEST(TurnLines, BecomeColumnsAtEveryLevel) {
    for (const std::string& level : simd_levels()) {
        ASSERT_TRUE(use_simd_level(level));
        for (const std::size_t lines : {1U, 2U, 3U, 4U, 5U, 8U, 15U, 31U, 32U})
            for (const std::size_t elements : {1U, 3U, 4U, 7U, 64U, 101U})
                expect_turned(lines, elements, lines % 3 * 8, lines % 4);
    }
    ASSERT_TRUE(use_simd_level("best"));
}

} // namespace
} // namespace linkdig::ig
