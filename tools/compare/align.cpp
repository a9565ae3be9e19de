#include "tools/compare/align.h"

#include "tools/flight/bad_input.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

namespace linkdig::compare {
namespace {

/// A picture without a number beside numbered ones, as the contact sheet of a dump, is no frame of the flight; only if the other
/// side has its namesake are the two compared.
bool is_beside_frames(const Entry& entry, const Side& own, const Side& other) {
    if (entry.key.number || !own.entries.back().key.number) return false; // those without a number come first
    return std::ranges::none_of(other.entries, [&](const Entry& each) {
        return !each.key.number && each.key.series == entry.key.series;
    });
}

/// `other` is the other side.
std::set<std::string> series_of(const Side& side, const Side& other, bool planes) {
    std::set<std::string> series;
    for (const Entry& entry : side.entries)
        if (!entry.key.plane.empty() == planes && !is_beside_frames(entry, side, other))
            series.insert(entry.key.series);
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
        const auto of_expected = series_of(expected, actual, planes);
        const auto of_actual = series_of(actual, expected, planes);
        const auto left = without(of_expected, of_actual);
        const auto right = without(of_actual, of_expected);
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
bool is_wanted(const Entry& entry, const Side& own, const Side& other,
               const std::optional<tools::FrameRange>& frames) {
    if (other.kind == Kind::recording && !entry.key.plane.empty()) return false;
    if (is_beside_frames(entry, own, other)) return false;
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
        if (is_wanted(expected.entries[k], expected, actual, frames))
            pairs[key_of(expected.entries[k], {})].expected = k;
    for (std::size_t k = 0; k < actual.entries.size(); ++k)
        if (is_wanted(actual.entries[k], actual, expected, frames))
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
