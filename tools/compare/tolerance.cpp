#include "tools/compare/tolerance.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string_view>

namespace linkdig::compare {
namespace {

constexpr std::uint64_t any = std::numeric_limits<std::uint64_t>::max();

template <class Number>
std::optional<Number> number(std::string_view text) {
    Number value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return value;
}

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && text.front() == ' ')
        text.remove_prefix(1);
    while (!text.empty() && text.back() == ' ')
        text.remove_suffix(1);
    return text;
}

bool read_count(std::string_view text, Bucket& bucket) {
    if (text == "*") {
        bucket.greatest = any;
        return true;
    }
    const std::size_t dash = text.find('-');
    const auto least =
        dash == std::string_view::npos ? 1 : number<std::uint64_t>(trimmed(text.substr(0, dash)));
    const std::string_view rest = dash == std::string_view::npos ? text : trimmed(text.substr(dash + 1));
    const auto greatest = rest == "*" ? any : number<std::uint64_t>(rest);
    if (!least || !greatest || *greatest == 0 || *least > *greatest) return false;
    bucket.least = *least;
    bucket.greatest = *greatest;
    return true;
}

Bucket parse_bucket(std::string_view text) {
    Bucket bucket;
    const std::size_t colon = text.find(':');
    if (text.starts_with("<=") && colon != std::string_view::npos) {
        const auto limit = number<double>(trimmed(text.substr(2, colon - 2)));
        if (limit && *limit > 0.0 && *limit <= 1e9 && read_count(trimmed(text.substr(colon + 1)), bucket)) {
            bucket.limit = *limit;
            return bucket;
        }
    }
    throw std::invalid_argument(fmt::format("'{}' is no tolerance; expected <=LEVELS:COUNT with COUNT a "
                                            "number of pixels, a range like 0-100 or *",
                                            text));
}

std::string count_text(const Bucket& bucket) {
    if (bucket.greatest == any) return bucket.least == 1 ? "*" : fmt::format("{}-*", bucket.least);
    return bucket.least == 1 ? fmt::format("{}", bucket.greatest)
                             : fmt::format("{}-{}", bucket.least, bucket.greatest);
}

} // namespace

Tolerance parse_tolerance(std::span<const std::string> texts) {
    Tolerance tolerance;
    for (const std::string& text : texts) {
        for (std::size_t begin = 0; begin <= text.size();) {
            const std::size_t end = std::min(text.find(',', begin), text.size());
            tolerance.push_back(parse_bucket(trimmed(std::string_view(text).substr(begin, end - begin))));
            begin = end + 1;
        }
    }
    const auto not_above = [](const Bucket& a, const Bucket& b) { return a.limit >= b.limit; };
    if (std::ranges::adjacent_find(tolerance, not_above) != tolerance.end())
        throw std::invalid_argument(fmt::format(
            "'{}': expected each bucket's levels above those of the one before", tolerance_text(tolerance)));
    return tolerance;
}

std::string tolerance_text(const Tolerance& tolerance) {
    std::vector<std::string> texts;
    for (const Bucket& bucket : tolerance)
        texts.push_back(fmt::format("<={}:{}", bucket.limit, count_text(bucket)));
    return texts.empty() ? "exact" : fmt::format("{}", fmt::join(texts, ", "));
}

bool is_within(const Tolerance& tolerance, std::span<const std::uint64_t> counts) {
    for (std::size_t k = 0; k < tolerance.size(); ++k)
        if (counts[k] > tolerance[k].greatest) return false;
    return counts[tolerance.size()] == 0;
}

void Declared::take(std::span<const std::uint64_t> counts) {
    for (std::size_t k = 0; k < most_.size(); ++k)
        most_[k] = std::max(most_[k], counts[k]);
}

std::string Declared::better() const {
    std::string text;
    for (std::size_t k = 0; k < most_.size(); ++k) {
        const Bucket& bucket = tolerance_[k];
        if (most_[k] >= bucket.least) continue;
        text += fmt::format(
            "better than declared: <={}:{} expects a frame with at least {} such pixels, the worst "
            "has {}; tighten the tolerance\n",
            bucket.limit, count_text(bucket), bucket.least, most_[k]);
    }
    return text;
}

} // namespace linkdig::compare
