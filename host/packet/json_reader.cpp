#include "host/packet/json_reader.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <optional>

namespace linkdig {

namespace {

std::optional<double> not_finite(const Json& json) {
    if (!json.is_string()) return std::nullopt;
    const auto& text = json.get_ref<const std::string&>();
    if (text == "nan") return std::numeric_limits<double>::quiet_NaN();
    if (text == "inf") return std::numeric_limits<double>::infinity();
    if (text == "-inf") return -std::numeric_limits<double>::infinity();
    return std::nullopt;
}

template <typename Vector>
void read_vector(const Json& json, const std::string& field, Vector& value) {
    constexpr auto axes = static_cast<std::size_t>(Vector::length());
    if (!json.is_array() || json.size() != axes)
        throw JsonMistake(field, fmt::format("expected an array of {} numbers", axes == 2 ? "two" : "three"));
    for (std::size_t axis = 0; axis < axes; ++axis)
        read_value(json[axis], fmt::format("{}[{}]", field, axis), value[static_cast<int>(axis)]);
}

/// The value of an enumeration, by its place among the names.
template <typename Enumeration, std::size_t count>
void read_name(const Json& json, const std::string& field, const char* const (&names)[count],
               Enumeration& value) {
    const auto found = std::ranges::find_if(names, [&](const char* name) { return json == name; });
    if (found == std::end(names))
        throw JsonMistake(field, fmt::format("expected \"{}\"", fmt::join(names, "\" or \"")));
    value = static_cast<Enumeration>(found - std::begin(names));
}

} // namespace

JsonMistake::JsonMistake(const std::string& field, std::string_view what)
    : std::runtime_error(field.empty() ? std::string(what) : fmt::format("{}: {}", field, what)) {}

Json parse_json(std::string_view text) {
    std::vector<std::set<std::string>> open_objects;
    const auto watch = [&](int, Json::parse_event_t event, Json& parsed) {
        if (event == Json::parse_event_t::object_start) open_objects.emplace_back();
        if (event == Json::parse_event_t::object_end) open_objects.pop_back();
        if (event == Json::parse_event_t::key) {
            const auto& name = parsed.get_ref<const std::string&>();
            if (!open_objects.back().insert(name).second)
                throw JsonMistake(name, "stands twice in one object");
        }
        return true;
    };
    try {
        return Json::parse(text, watch);
    } catch (const nlohmann::json::exception& error) {
        throw JsonMistake("", fmt::format("not JSON: {}", error.what()));
    }
}

void read_value(const Json& json, const std::string& field, bool& value) {
    if (!json.is_boolean()) throw JsonMistake(field, "expected true or false");
    value = json.get<bool>();
}

void read_value(const Json& json, const std::string& field, std::string& value) {
    if (!json.is_string()) throw JsonMistake(field, "expected a string");
    value = json.get<std::string>();
}

void read_value(const Json& json, const std::string& field, double& value) {
    if (const auto special = not_finite(json)) {
        value = *special;
    } else if (json.is_number()) {
        value = json.get<double>();
    } else {
        throw JsonMistake(field, "expected a number");
    }
}

void read_value(const Json& json, const std::string& field, float& value) {
    double wide = 0.0;
    read_value(json, field, wide);
    if (std::isfinite(wide) && std::fabs(wide) > std::numeric_limits<float>::max())
        throw JsonMistake(field, "out of range for a 32-bit float");
    value = static_cast<float>(wide);
}

void read_value(const Json& json, const std::string& field, Vec2d& value) { read_vector(json, field, value); }
void read_value(const Json& json, const std::string& field, Vec3f& value) { read_vector(json, field, value); }
void read_value(const Json& json, const std::string& field, Vec3d& value) { read_vector(json, field, value); }

void read_value(const Json& json, const std::string& field, ShadingMethod& value) {
    read_name(json, field, shading_method_names, value);
}

void read_value(const Json& json, const std::string& field, WakeMethod& value) {
    read_name(json, field, wake_method_names, value);
}

void read_value(const Json& json, const std::string& field, std::int64_t& value) {
    constexpr auto greatest = static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
    const bool fits =
        json.is_number_integer() && (!json.is_number_unsigned() || json.get<std::uint64_t>() <= greatest);
    if (!fits) throw JsonMistake(field, "expected a whole number of 64 bits");
    value = json.get<std::int64_t>();
}

void read_value(const Json& json, const std::string& field, std::int32_t& value) {
    constexpr std::int64_t greatest = std::numeric_limits<std::int32_t>::max();
    const bool fits = json.is_number_unsigned()
                          ? json.get<std::uint64_t>() <= std::uint64_t{greatest}
                          : json.is_number_integer() && json.get<std::int64_t>() == none;
    if (!fits)
        throw JsonMistake(field, fmt::format("expected an integer from 0 to {}, or -1 for none", greatest));
    value = json.get<std::int32_t>();
}

std::uint64_t read_unsigned(const Json& json, const std::string& field, std::uint64_t greatest) {
    // An integer that a program built, not parsed, is of the signed kind.
    const bool whole =
        json.is_number_unsigned() || (json.is_number_integer() && json.get<std::int64_t>() >= 0);
    if (!whole || json.get<std::uint64_t>() > greatest)
        throw JsonMistake(field, fmt::format("expected an integer from 0 to {}", greatest));
    return json.get<std::uint64_t>();
}

void read_bits(const Json& json, const std::string& field, std::uint64_t& value) {
    if (!json.is_string()) {
        read_value(json, field, value);
        return;
    }
    const auto& text = json.get_ref<const std::string&>();
    constexpr std::size_t prefix = 2;
    const char* const end = text.data() + text.size();
    bool good = text.starts_with("0x") && text.size() > prefix;
    if (good) {
        const auto parsed = std::from_chars(text.data() + prefix, end, value, 16);
        good = parsed.ec == std::errc{} && parsed.ptr == end;
    }
    if (!good) throw JsonMistake(field, "expected \"0x\" and up to 16 hexadecimal digits, or an integer");
}

JsonReader::JsonReader(const Json& json, std::string field) : json_(json), field_(std::move(field)) {
    if (!json.is_object()) throw JsonMistake(field_, "expected an object");
}

const Json* JsonReader::find(const char* name) {
    known_.insert(name);
    const auto found = json_.find(name);
    return found == json_.end() ? nullptr : &*found;
}

std::string JsonReader::path(std::string_view name) const {
    return field_.empty() ? std::string(name) : fmt::format("{}.{}", field_, name);
}

void JsonReader::finish() const {
    for (const auto& [name, value] : json_.items())
        if (!known_.contains(name))
            throw JsonMistake(path(name),
                              fmt::format("unknown field; expected one of {}", fmt::join(known_, ", ")));
}

} // namespace linkdig
