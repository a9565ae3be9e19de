#pragma once
/// Which frame of one side belongs to which of the other.

#include "tools/compare/side.h"
#include "tools/flight/arguments.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace linkdig::compare {

struct Pair {
    std::optional<std::size_t> expected; ///< into the side's entries; empty: an extra frame
    std::optional<std::size_t> actual;   ///< empty: a missing frame
};

/// By number and series, ascending. Series of equal name belong together; of the pictures' (not planes')
/// series, what remains belongs together if it is one on either side: frame0001.png is compared with
/// colour_000001.png. Pictures without a number beside numbered ones do not count, unless both
/// sides have one of that name. `frames` drops frames of other numbers. Two single pictures are a pair whatever their
/// names. Throws tools::BadInput if the sides are not of comparable kinds.
std::vector<Pair> align(const Side& expected, const Side& actual,
                        const std::optional<tools::FrameRange>& frames);

} // namespace linkdig::compare
