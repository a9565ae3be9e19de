#include "database/text/diagnostic.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <utility>

namespace linkdig::database {

void Diagnostics::error(SourceLocation at, std::string message) {
    errors_.push_back({std::move(at), std::move(message)});
}

std::string Diagnostics::text() const {
    std::vector<Diagnostic> sorted = errors_;
    std::stable_sort(sorted.begin(), sorted.end(), [](const Diagnostic& a, const Diagnostic& b) {
        return std::tie(a.at.file, a.at.line, a.at.column) < std::tie(b.at.file, b.at.line, b.at.column);
    });
    std::string result;
    for (const Diagnostic& each : sorted)
        result +=
            fmt::format("{}:{}:{}: error: {}\n", each.at.file, each.at.line, each.at.column, each.message);
    return result;
}

namespace {

/// Optimal string alignment distance: insertions, deletions, replacements and swaps of neighbours.
std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> before_last(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j)
        last[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t replaced = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            row[j] = std::min({replaced, last[j] + 1, row[j - 1] + 1});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                row[j] = std::min(row[j], before_last[j - 2] + 1);
        }
        before_last.swap(last);
        last.swap(row);
    }
    return last[b.size()];
}

/// Longer words than these are no typing mistakes of each other, and would only cost time.
constexpr std::size_t longest_word = 64;

} // namespace

std::string suggestion(std::string_view word, const std::vector<std::string>& candidates) {
    if (word.size() > longest_word) return {};
    std::size_t best = std::max<std::size_t>(1, word.size() / 3) + 1;
    const std::string* closest = nullptr;
    for (const std::string& candidate : candidates) {
        if (candidate.size() > longest_word) continue;
        const std::size_t distance = edit_distance(word, candidate);
        if (distance < best) {
            best = distance;
            closest = &candidate;
        }
    }
    return closest == nullptr ? std::string() : fmt::format("\"{}\"", *closest);
}

} // namespace linkdig::database
