#pragma once
/// Values of a frame packet from JSON, checked for type and range where they stand.

#include "host/packet/json_writer.h"

#include <limits>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>

namespace linkdig {

/// A value that is not what its field asks for. The text begins with the field's name.
class JsonMistake : public std::runtime_error {
public:
    JsonMistake(const std::string& field, std::string_view what);
};

/// Parses text; a syntax error or a field that stands twice in its object is a JsonMistake.
Json parse_json(std::string_view text);

/// `field` names the value in messages.
void read_value(const Json& json, const std::string& field, bool& value);
void read_value(const Json& json, const std::string& field, std::string& value);
void read_value(const Json& json, const std::string& field, double& value);
void read_value(const Json& json, const std::string& field, float& value);
void read_value(const Json& json, const std::string& field, Vec2d& value);
void read_value(const Json& json, const std::string& field, Vec3f& value);
void read_value(const Json& json, const std::string& field, Vec3d& value);
void read_value(const Json& json, const std::string& field, ShadingMethod& value);
void read_value(const Json& json, const std::string& field, WakeMethod& value);
/// "0x1f", or an integer.
void read_bits(const Json& json, const std::string& field, std::uint64_t& value);
std::uint64_t read_unsigned(const Json& json, const std::string& field, std::uint64_t greatest);

inline void read_value(const Json& json, const std::string& field, std::uint64_t& value) {
    value = read_unsigned(json, field, std::numeric_limits<std::uint64_t>::max());
}
inline void read_value(const Json& json, const std::string& field, std::uint32_t& value) {
    value = static_cast<std::uint32_t>(read_unsigned(json, field, std::numeric_limits<std::uint32_t>::max()));
}
inline void read_value(const Json& json, const std::string& field, std::uint8_t& value) {
    value = static_cast<std::uint8_t>(read_unsigned(json, field, 255));
}
/// Any whole number.
void read_value(const Json& json, const std::string& field, std::int64_t& value);
/// An index, or -1 for none.
void read_value(const Json& json, const std::string& field, std::int32_t& value);

template <typename Struct>
requires std::is_aggregate_v<Struct>
void read_value(const Json& json, const std::string& field, Struct& value);

template <typename Row>
void read_value(const Json& json, const std::string& field, std::vector<Row>& rows) {
    if (!json.is_array()) throw JsonMistake(field, "expected an array");
    rows.clear();
    for (const Json& row : json) {
        const std::string row_field = field + "[" + std::to_string(rows.size()) + "]";
        read_value(row, row_field, rows.emplace_back());
    }
}

/// Visitor of packet_fields.h.
class JsonReader {
public:
    /// Throws JsonMistake if it is no object.
    JsonReader(const Json& json, std::string field);

    template <typename Value>
    void operator()(const char* name, Value& value) {
        if (const Json* json = find(name)) read_value(*json, path(name), value);
    }
    template <typename Value>
    void required(const char* name, Value& value) {
        const Json* json = find(name);
        if (json == nullptr) throw JsonMistake(path(name), "missing");
        read_value(*json, path(name), value);
    }
    void bits(const char* name, std::uint64_t& value) {
        if (const Json* json = find(name)) read_bits(*json, path(name), value);
    }
    /// Throws JsonMistake if a field was never asked for. Call once, last.
    void finish() const;

private:
    const Json* find(const char* name);
    std::string path(std::string_view name) const;

    const Json& json_;
    std::string field_;
    std::set<std::string, std::less<>> known_;
};

template <typename Struct>
requires std::is_aggregate_v<Struct>
void read_value(const Json& json, const std::string& field, Struct& value) {
    JsonReader reader(json, field);
    fields(reader, value);
    reader.finish();
}

} // namespace linkdig
