#include "ig/video/turn_lines.h"

#include "ig/simd/simd_level.h"

#ifndef LINKDIG_TURN_LINES_ONCE // this file is compiled once per SIMD level
#define LINKDIG_TURN_LINES_ONCE
namespace linkdig::ig {
namespace {

/// Elements [from, to) of lines [first, end), one by one.
void turn_plainly(const LinesToTurn& t, std::size_t first, std::size_t end, std::size_t from,
                  std::size_t to) {
    for (std::size_t element = from; element < to; ++element)
        for (std::size_t line = first; line < end; ++line)
            t.picture[element * t.width + line] = t.pixels[line * t.length + element];
}

} // namespace
} // namespace linkdig::ig
#endif

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "ig/video/turn_lines.cpp"
#include <hwy/foreach_target.h> // compiles this file once for every SIMD level
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace linkdig::ig {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

#if HWY_TARGET != HWY_SCALAR

using Four = hn::FixedTag<std::uint32_t, 4>;
using Two = hn::FixedTag<std::uint64_t, 2>;

/// Four elements of four lines become four lines of four elements.
HWY_INLINE void TurnBlock(const std::uint32_t* pixels, std::size_t length, std::uint32_t* picture,
                          std::size_t width) {
    const Four d;
    const Two pairs;
    const auto a = hn::LoadU(d, pixels), b = hn::LoadU(d, pixels + length);
    const auto c = hn::LoadU(d, pixels + 2 * length), e = hn::LoadU(d, pixels + 3 * length);
    const auto low_ab = hn::BitCast(pairs, hn::InterleaveLower(d, a, b));
    const auto low_ce = hn::BitCast(pairs, hn::InterleaveLower(d, c, e));
    const auto high_ab = hn::BitCast(pairs, hn::InterleaveUpper(d, a, b));
    const auto high_ce = hn::BitCast(pairs, hn::InterleaveUpper(d, c, e));
    hn::StoreU(hn::BitCast(d, hn::InterleaveLower(pairs, low_ab, low_ce)), d, picture);
    hn::StoreU(hn::BitCast(d, hn::InterleaveUpper(pairs, low_ab, low_ce)), d, picture + width);
    hn::StoreU(hn::BitCast(d, hn::InterleaveLower(pairs, high_ab, high_ce)), d, picture + 2 * width);
    hn::StoreU(hn::BitCast(d, hn::InterleaveUpper(pairs, high_ab, high_ce)), d, picture + 3 * width);
}

void TurnLines(const LinesToTurn& t) {
    const std::size_t lines = t.lines / 4 * 4, elements = t.elements / 4 * 4;
    for (std::size_t element = 0; element < elements; element += 4)
        for (std::size_t line = 0; line < lines; line += 4)
            TurnBlock(t.pixels + line * t.length + element, t.length, t.picture + element * t.width + line,
                      t.width);
    turn_plainly(t, lines, t.lines, 0, elements);
    turn_plainly(t, 0, t.lines, elements, t.elements);
}

#else // one lane

void TurnLines(const LinesToTurn& t) { turn_plainly(t, 0, t.lines, 0, t.elements); }

#endif

} // namespace HWY_NAMESPACE
} // namespace linkdig::ig
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace linkdig::ig {

namespace {

HWY_EXPORT(TurnLines);

} // namespace

void turn_lines(const LinesToTurn& turned) {
    if (simd_is_off()) {
        turn_plainly(turned, 0, turned.lines, 0, turned.elements);
    } else {
        HWY_DYNAMIC_DISPATCH(TurnLines)(turned);
    }
}

} // namespace linkdig::ig
#endif
