/// TableReader's quantities with units, vectors, and nested values.

#include "database/model/mathematics.h"
#include "database/model/units.h"
#include "database/text/key_words.h"
#include "database/text/table_reader.h"
#include "database/text/value_reading.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace linkdig::database {

namespace {

using Units = std::vector<std::pair<const char*, double>>;

const Units& length_units() {
    static const Units units{{"_m", 1.0}, {"_ft", metres_per_foot}};
    return units;
}

const Units& speed_units() {
    static const Units units{{"_kt", mps_per_knot}, {"_mps", 1.0}};
    return units;
}

template <int count>
using Point = glm::vec<count, double, glm::defaultp>;

template <int count>
std::optional<Point<count>> point_of(const toml::node& node, double unit) {
    const toml::array* array = node.as_array();
    if (array == nullptr || array->size() != count) return std::nullopt;
    Point<count> point(0.0);
    for (int i = 0; i < count; ++i) {
        const std::optional<double> value = finite_number(*array->get(static_cast<std::size_t>(i)));
        if (!value) return std::nullopt;
        point[i] = *value * unit;
    }
    return point;
}

template <int count>
constexpr const char* point_text() {
    return count == 3 ? "[x, y, z], three finite numbers" : "[x, y], two finite numbers";
}

} // namespace

std::optional<Vec3d> point_of_node(const toml::node& node) { return point_of<3>(node, 1.0); }

/// The value whose key is `stem` with one of the units' endings. Nothing if it is absent or ambiguous.
std::optional<TableReader::WithUnit> TableReader::with_unit(std::string_view stem, const Units& units,
                                                            bool required) {
    std::optional<WithUnit> result;
    std::string keys;
    for (const auto& [ending, unit] : units) {
        const std::string key = std::string(stem) + ending;
        keys += keys.empty() ? fmt::format("\"{}\"", key) : fmt::format(" or \"{}\"", key);
        const toml::node* found = find(key);
        if (found == nullptr) continue;
        if (result)
            error_at(key, fmt::format("both \"{}\" and \"{}\" stand in {}; expected one of them", result->key,
                                      key, what_));
        else
            result = WithUnit{key, found, unit};
    }
    if (!result && required) diagnostics_->error(here(), fmt::format("{} lacks the key {}", what_, keys));
    return result;
}

/// Under the first unit's key; the others are named with the value.
void TableReader::note_with_units(std::string_view stem, const Units& units, std::string value,
                                  std::optional<std::string> fallback) {
    const auto whole = [&](std::size_t i) { return std::string(stem) + units[i].first; };
    for (std::size_t i = 1; i < units.size(); ++i)
        value += fmt::format("; or `{}`", whole(i));
    note(whole(0), std::move(value), std::move(fallback));
}

double TableReader::quantity(std::string_view stem, const Units& units, std::optional<double> fallback,
                             Range range) {
    if (noting())
        note_with_units(stem, units, "number" + words_of(range),
                        fallback ? std::optional(fmt::format("{:.6g}", *fallback)) : std::nullopt);
    const std::optional<WithUnit> found = with_unit(stem, units, !fallback);
    if (found) return number_of(found->key, *found->node, range, found->unit);
    return fallback ? *fallback : std::max(range.least, std::min(range.greatest, 0.0));
}

double TableReader::length_m(std::string_view stem, std::optional<double> fallback, Range range_m) {
    return quantity(stem, length_units(), fallback, range_m);
}

double TableReader::speed_mps(std::string_view stem, std::optional<double> fallback, Range range_mps) {
    return quantity(stem, speed_units(), fallback, range_mps);
}

double TableReader::duration_s(std::string_view stem, std::optional<double> fallback, Range range) {
    return quantity(stem, {{"_s", 1.0}}, fallback, range);
}

double TableReader::angle_rad(std::string_view stem, std::optional<double> fallback_deg, Range range_deg) {
    return radians(quantity(stem, {{"_deg", 1.0}}, fallback_deg, range_deg));
}

namespace {

template <int count>
std::optional<std::string> words_of(const std::optional<Point<count>>& point) {
    if (!point) return std::nullopt;
    std::string words;
    for (int i = 0; i < count; ++i)
        words += fmt::format("{}{:.6g}", i == 0 ? "[" : ", ", (*point)[i]);
    return words + "]";
}

} // namespace

template <int count>
Point<count> TableReader::point_with_unit(std::string_view stem, std::optional<Point<count>> fallback) {
    if (noting())
        note_with_units(stem, length_units(), count == 3 ? "[x, y, z]" : "[x, y]", words_of<count>(fallback));
    const std::optional<WithUnit> found = with_unit(stem, length_units(), !fallback);
    if (!found) return fallback.value_or(Point<count>(0.0));
    if (const auto point = point_of<count>(*found->node, found->unit)) return *point;
    wrong_type(found->key, *found->node, point_text<count>());
    return Point<count>(0.0);
}

Vec3d TableReader::point_m(std::string_view stem, std::optional<Vec3d> fallback) {
    return point_with_unit<3>(stem, fallback);
}

Vec2d TableReader::point2_m(std::string_view stem, std::optional<Vec2d> fallback) {
    return point_with_unit<2>(stem, fallback);
}

std::array<double, 2> TableReader::range_m(std::string_view stem, Range range_m) {
    const std::string value = "[least, greatest]" + words_of(range_m);
    if (noting()) note_with_units(stem, length_units(), value, {});
    const std::optional<WithUnit> found = with_unit(stem, length_units(), true);
    if (!found) return {range_m.least, range_m.least};
    const auto pair = point_of<2>(*found->node, found->unit);
    if (pair && pair->x >= range_m.least && pair->y >= pair->x && pair->y <= range_m.greatest)
        return {pair->x, pair->y};
    error_at(found->key, fmt::format("\"{}\" is no range; expected {}{}", found->key, value,
                                     found->unit == 1.0 ? "" : " in metres"));
    return {range_m.least, range_m.least};
}

Vec3d TableReader::vector(std::string_view key, std::optional<Vec3d> fallback) {
    if (noting()) note(key, "[x, y, z]", words_of<3>(fallback));
    const toml::node* found = find(key);
    if (found == nullptr) {
        if (!fallback) missing(key);
        return fallback.value_or(Vec3d(0.0));
    }
    if (const auto point = point_of<3>(*found, 1.0)) return *point;
    wrong_type(key, *found, point_text<3>());
    return Vec3d(0.0);
}

template <int count>
std::vector<glm::vec<count, double, glm::defaultp>> TableReader::points_of(std::string_view stem) {
    std::vector<Point<count>> points;
    if (noting())
        note_with_units(stem, length_units(), count == 3 ? "array of [x, y, z]" : "array of [x, y]", {});
    const std::optional<WithUnit> found = with_unit(stem, length_units(), true);
    if (!found) return points;
    const toml::array* array = found->node->as_array();
    if (array == nullptr) {
        wrong_type(found->key, *found->node, fmt::format("an array of {}", point_text<count>()));
        return points;
    }
    for (const toml::node& each : *array) {
        if (const auto point = point_of<count>(each, found->unit))
            points.push_back(*point);
        else
            wrong_type(found->key, each, point_text<count>());
    }
    return points;
}

std::vector<Vec3d> TableReader::points_m(std::string_view stem) { return points_of<3>(stem); }
std::vector<Vec2d> TableReader::points2_m(std::string_view stem) { return points_of<2>(stem); }

std::vector<std::string> TableReader::texts(std::string_view key) {
    std::vector<std::string> result;
    if (noting()) note(key, "array of texts", "none");
    const toml::node* found = find(key);
    if (found == nullptr) return result;
    const toml::array* array = found->as_array();
    if (array == nullptr) {
        wrong_type(key, *found, "an array of texts");
        return result;
    }
    for (const toml::node& each : *array) {
        if (const auto value = each.value_exact<std::string>())
            result.push_back(*value);
        else
            wrong_type(key, each, "a text in quotes");
    }
    return result;
}

const toml::table* TableReader::table(std::string_view key) {
    if (noting()) note(key, "table", "none");
    const toml::node* found = find(key);
    if (found == nullptr) return nullptr;
    if (found->as_table() == nullptr) wrong_type(key, *found, "a table");
    return found->as_table();
}

std::vector<const toml::table*> TableReader::tables(std::string_view key) {
    std::vector<const toml::table*> result;
    if (noting()) note(key, "array of tables", "none");
    const toml::node* found = find(key);
    if (found == nullptr) return result;
    const toml::array* array = found->as_array();
    if (array == nullptr) {
        wrong_type(key, *found, fmt::format("an array of tables: [[{}]]", key));
        return result;
    }
    for (const toml::node& each : *array) {
        if (each.as_table() != nullptr)
            result.push_back(each.as_table());
        else
            wrong_type(key, each, "a table");
    }
    return result;
}

} // namespace linkdig::database
