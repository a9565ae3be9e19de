#pragma once
/// What a comparison says in the terminal.

#include "tools/compare/compare.h"

#include <string>
#include <vector>

namespace linkdig::compare {

/// All there is to say of a case, but for the closing line; empty if nothing differs.
std::string text_of(const CaseResult& result, ig::Scan scan);

/// One line on all cases: "same: 2000 frames", "differs: 3 of 2000 frames, first ...".
std::string closing_line(const std::vector<CaseResult>& results);

/// "frame_000010.png, line 12, element 40, channel R: expected 142, got 143".
std::string place_text(const Place& place, ig::Scan scan);

/// "frames 10 to 20, 35": names of frames that follow one another are drawn together.
std::string names_text(const std::vector<std::string>& names);

/// A bar per power of two of levels.
std::string histogram_text(const std::array<std::uint64_t, beyond_levels + 1>& histogram);

} // namespace linkdig::compare
