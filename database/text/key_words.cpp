#include "database/text/key_words.h"

#include <fmt/format.h>

#include <limits>

namespace linkdig::database {

std::string words_of(Range range) {
    const Range any;
    if (range.least == any.least && range.greatest == any.greatest) return {};
    if (range.greatest == any.greatest) return fmt::format(", at least {:.6g}", range.least);
    if (range.least == any.least) return fmt::format(", at most {:.6g}", range.greatest);
    return fmt::format(", {:.6g} to {:.6g}", range.least, range.greatest);
}

std::string words_of(std::int64_t least, std::int64_t greatest) {
    if (greatest == std::numeric_limits<std::int64_t>::max())
        return fmt::format("whole number, at least {}", least);
    return fmt::format("whole number, {} to {}", least, greatest);
}

bool is_other_unit(const std::string& key, const std::set<std::string, std::less<>>& known) {
    const auto other = [&](const char* ending, const char* first) {
        return key.ends_with(ending) &&
               known.contains(key.substr(0, key.size() - std::char_traits<char>::length(ending)) + first);
    };
    return other("_ft", "_m") || other("_mps", "_kt");
}

} // namespace linkdig::database
