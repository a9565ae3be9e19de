#include "database/text/value_reading.h"

#include <fmt/format.h>

#include <cmath>

namespace linkdig::database {

std::string kind_of(const toml::node& node) {
    if (const auto* number = node.as_floating_point()) {
        if (std::isnan(number->get())) return "not a number";
        if (std::isinf(number->get())) return "infinite";
    }
    switch (node.type()) {
    case toml::node_type::string:
        return "a text";
    case toml::node_type::integer:
        return "a whole number";
    case toml::node_type::floating_point:
        return "a number";
    case toml::node_type::boolean:
        return "true or false";
    case toml::node_type::array:
        return "an array";
    case toml::node_type::table:
        return "a table";
    default:
        return "a date or time";
    }
}

std::optional<double> finite_number(const toml::node& node) {
    if (const auto* number = node.as_floating_point())
        return std::isfinite(number->get()) ? std::optional(number->get()) : std::nullopt;
    if (const auto* number = node.as_integer()) return static_cast<double>(number->get());
    return std::nullopt;
}

std::string range_text(Range range, double unit) {
    const bool below = range.least > Range().least;
    const bool above = range.greatest < Range().greatest;
    const double least = range.least / unit;
    const double greatest = range.greatest / unit;
    if (below && above) return fmt::format("{:.6g} to {:.6g}", least, greatest);
    if (below) return fmt::format("at least {:.6g}", least);
    if (above) return fmt::format("at most {:.6g}", greatest);
    return "a finite number";
}

} // namespace linkdig::database
