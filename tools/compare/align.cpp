#include "tools/compare/align.h"

#include "tools/flight/bad_input.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

namespace linkdig::compare {
namespace {

std::set<std::string> series_of(const Side& side, bool planes) {
    std::set<std::string> series;
    for (const Entry& entry : side.entries)
        if (!entry.key.plane.empty() == planes) series.insert(entry.key.series);
    return series;
}

std::set<std::string> without(const std::set<std::string>& a, const std::set<std::string>& b) {
    std::set<std::string> rest;
    std::ranges::set_difference(a, b, std::inserter(rest, rest.end()));
    return rest;
}

/// What the actual side's series are called on the expected side.
std::map<std::string, std::string> renamed(const Side& expected, const Side& actual) {
    std::map<std::string, std::string> names;
    for (const bool planes : {false, true}) {
        const auto left = without(series_of(expected, planes), series_of(actual, planes));
        const auto right = without(series_of(actual, planes), series_of(expected, planes));
        if (left.size() == 1 && right.size() == 1) names[*right.begin()] = *left.begin();
    }
    return names;
}

using Key = std::tuple<std::uint64_t, bool, std::uint64_t, std::string>;

Key key_of(const Entry& entry, const std::map<std::string, std::string>& names) {
    const auto found = names.find(entry.key.series);
    return {entry.pass, entry.key.number.has_value(), entry.key.number.value_or(0),
            found == names.end() ? entry.key.series : found->second};
}

/// A recording has no files of planes: those of a folder beside it only explain its pictures.
bool is_wanted(const Entry& entry, const Side& other, const std::optional<tools::FrameRange>& frames) {
    if (other.kind == Kind::recording && !entry.key.plane.empty()) return false;
    return !frames ||
           (entry.key.number && *entry.key.number >= frames->first && *entry.key.number <= frames->last);
}

} // namespace

std::vector<Pair> align(const Side& expected, const Side& actual,
                        const std::optional<tools::FrameRange>& frames) {
    const bool single = expected.kind == Kind::picture;
    if (single != (actual.kind == Kind::picture))
        throw tools::BadInput(
            fmt::format("linkdig: error: {} is {}, {} is {}; expected two pictures, or frames "
                        "on both sides",
                        expected.path, kind_text(expected.kind), actual.path, kind_text(actual.kind)));
    if (single) return {{0, 0}};
    const auto names = renamed(expected, actual);
    std::map<Key, Pair> pairs;
    for (std::size_t k = 0; k < expected.entries.size(); ++k)
        if (is_wanted(expected.entries[k], actual, frames))
            pairs[key_of(expected.entries[k], {})].expected = k;
    for (std::size_t k = 0; k < actual.entries.size(); ++k)
        if (is_wanted(actual.entries[k], expected, frames))
            pairs[key_of(actual.entries[k], names)].actual = k;
    if (pairs.empty())
        throw tools::BadInput("linkdig: error: neither side has a frame in the range of --frames");
    std::vector<Pair> sorted;
    sorted.reserve(pairs.size());
    for (const auto& [key, pair] : pairs)
        sorted.push_back(pair);
    return sorted;
}

} // namespace linkdig::compare
