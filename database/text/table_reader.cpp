#include "database/text/table_reader.h"

#include "database/text/key_log.h"
#include "database/text/key_words.h"

#include "database/text/value_reading.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

namespace linkdig::database {

TableReader::TableReader(const toml::table& table, std::string file, std::string what,
                         Diagnostics& diagnostics)
    : table_(&table), file_(std::move(file)), what_(std::move(what)), diagnostics_(&diagnostics) {}

SourceLocation TableReader::here() const { return location_of(*table_, file_); }

SourceLocation TableReader::at(std::string_view key) const {
    const toml::node* found = table_->get(key);
    return found == nullptr ? here() : location_of(*found, file_);
}

bool TableReader::has(std::string_view key) const { return table_->contains(key); }

void TableReader::error_at(std::string_view key, std::string message) const {
    diagnostics_->error(at(key), std::move(message));
}

const toml::node* TableReader::find(std::string_view key) {
    known_.emplace(key);
    return table_->get(key);
}

const toml::node* TableReader::node(std::string_view key) { return find(key); }

/// "[[object.box]]" of "[[object.box]] of [[object]] \"a\""; a sub-table's kind stands before: "repeat of ...".
static std::string table_of(const std::string& what) {
    const std::size_t begin = what.find('[');
    if (begin == std::string::npos) return what;
    const std::string table = what.substr(begin, what.find(' ', begin) - begin);
    return begin == 0 ? table : what.substr(0, what.find(' ')) + " of " + table;
}

std::string TableReader::beside(const std::string& name) const {
    return (std::filesystem::path(file_).parent_path() / name).lexically_normal().string();
}

void TableReader::note(std::string_view key, std::string value, std::optional<std::string> fallback) const {
    diagnostics_->keys()->note(table_of(what_), {std::string(key), std::move(value), std::move(fallback)});
}

void TableReader::describe(std::string_view key, std::string_view value,
                           std::optional<std::string> fallback) {
    known_.emplace(key);
    if (noting() && !value.empty()) note(key, std::string(value), std::move(fallback));
}

void TableReader::missing(std::string_view key) const {
    diagnostics_->error(here(), fmt::format("{} lacks the key \"{}\"", what_, key));
}

void TableReader::wrong_type(std::string_view key, const toml::node& found, std::string_view expected) const {
    diagnostics_->error(location_of(found, file_),
                        fmt::format("\"{}\" is {}; expected {}", key, kind_of(found), expected));
}

std::string TableReader::text_of(std::string_view key, const toml::node& found) const {
    if (const auto value = found.value_exact<std::string>()) {
        if (!value->empty()) return *value;
        error_at(key, fmt::format("\"{}\" is an empty text; expected at least one character", key));
    } else {
        wrong_type(key, found, "a text in quotes");
    }
    return {};
}

std::string TableReader::text(std::string_view key) {
    if (noting()) note(key, "text", {});
    const toml::node* found = find(key);
    if (found != nullptr) return text_of(key, *found);
    missing(key);
    return {};
}

std::string TableReader::text(std::string_view key, std::string_view fallback) {
    if (noting()) note(key, "text", fallback.empty() ? "none" : fmt::format("\"{}\"", fallback));
    const toml::node* found = find(key);
    return found == nullptr ? std::string(fallback) : text_of(key, *found);
}

double TableReader::number_of(std::string_view key, const toml::node& found, Range range, double unit) const {
    const std::optional<double> written = finite_number(found);
    if (!written) {
        wrong_type(key, found, "a finite number");
        return std::max(range.least, std::min(range.greatest, 0.0));
    }
    const double value = *written * unit;
    if (value >= range.least && value <= range.greatest) return value;
    error_at(key, fmt::format("\"{}\" is {}; expected {}", key, *written, range_text(range, unit)));
    return value < range.least ? range.least : range.greatest;
}

double TableReader::number(std::string_view key, Range range) {
    if (noting()) note(key, "number" + words_of(range), {});
    const toml::node* found = find(key);
    if (found != nullptr) return number_of(key, *found, range, 1.0);
    missing(key);
    return std::max(range.least, std::min(range.greatest, 0.0));
}

double TableReader::number(std::string_view key, double fallback, Range range) {
    if (noting()) note(key, "number" + words_of(range), fmt::format("{:.6g}", fallback));
    const toml::node* found = find(key);
    return found == nullptr ? fallback : number_of(key, *found, range, 1.0);
}

std::int64_t TableReader::integer_of(std::string_view key, const toml::node& found, std::int64_t least,
                                     std::int64_t greatest) const {
    const auto value = found.value_exact<std::int64_t>();
    if (!value) {
        wrong_type(key, found, "a whole number");
        return std::clamp<std::int64_t>(0, least, greatest);
    }
    if (*value < least || *value > greatest)
        error_at(key, fmt::format("\"{}\" is {}; expected {} to {}", key, *value, least, greatest));
    return std::clamp(*value, least, greatest);
}

std::int64_t TableReader::integer(std::string_view key, std::int64_t least, std::int64_t greatest) {
    if (noting()) note(key, words_of(least, greatest), {});
    const toml::node* found = find(key);
    if (found != nullptr) return integer_of(key, *found, least, greatest);
    missing(key);
    return std::clamp<std::int64_t>(0, least, greatest);
}

std::int64_t TableReader::integer(std::string_view key, std::int64_t fallback, std::int64_t least,
                                  std::int64_t greatest) {
    if (noting()) note(key, words_of(least, greatest), fmt::format("{}", fallback));
    const toml::node* found = find(key);
    return found == nullptr ? fallback : integer_of(key, *found, least, greatest);
}

bool TableReader::boolean(std::string_view key, bool fallback) {
    if (noting()) note(key, "true or false", fallback ? "true" : "false");
    const toml::node* found = find(key);
    if (found == nullptr) return fallback;
    if (const auto value = found->value_exact<bool>()) return *value;
    wrong_type(key, *found, "true or false");
    return fallback;
}

std::size_t TableReader::choice(std::string_view key, std::size_t fallback,
                                const std::vector<std::string>& choices) {
    if (noting())
        note(key, fmt::format("\"{}\"", fmt::join(choices, "\" or \"")),
             fmt::format("\"{}\"", choices.at(fallback)));
    const toml::node* found = find(key);
    if (found == nullptr) return fallback;
    const std::string listed = fmt::format("\"{}\"", fmt::join(choices, "\", \""));
    const auto value = found->value_exact<std::string>();
    if (!value) {
        wrong_type(key, *found, "one of " + listed);
        return fallback;
    }
    for (std::size_t i = 0; i < choices.size(); ++i)
        if (choices[i] == *value) return i;
    error_at(key, fmt::format("\"{}\" is \"{}\"; expected one of {}", key, *value, listed));
    return fallback;
}

void TableReader::finish() {
    const std::vector<std::string> candidates(known_.begin(), known_.end());
    for (const std::string& key : candidates)
        if (noting() && !is_other_unit(key, known_)) note(key, undescribed, {});
    for (auto&& [key, value] : *table_) {
        if (known_.find(key.str()) != known_.end()) continue;
        const std::string closest = suggestion(key.str(), candidates);
        const std::string advice = closest.empty()
                                       ? fmt::format("expected one of: {}", fmt::join(candidates, ", "))
                                       : fmt::format("did you mean {}?", closest);
        const toml::source_position at_key = key.source().begin;
        diagnostics_->error({file_, at_key.line, at_key.column},
                            fmt::format("unknown key \"{}\" in {}; {}", key.str(), what_, advice));
    }
}

} // namespace linkdig::database
