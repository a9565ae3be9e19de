#pragma once
/// Values of a frame packet as JSON.

#include "host/packet/packet_fields.h"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace linkdig {

using Json = nlohmann::ordered_json;

/// "0x1f".
std::string hexadecimal(std::uint64_t bits);

inline Json json_of(bool value) { return value; }
template <std::integral Integer>
requires(!std::same_as<Integer, bool>) Json json_of(Integer value) { return value; }
Json json_of(double value);
/// The shortest decimal number that is read back as this float, not the longer one of its value as a double.
Json json_of(float value);
Json json_of(ShadingMethod method);
Json json_of(WakeMethod method);
inline Json json_of(const Vec2d& v) { return Json::array({json_of(v.x), json_of(v.y)}); }
inline Json json_of(const Vec3f& v) { return Json::array({json_of(v.x), json_of(v.y), json_of(v.z)}); }
inline Json json_of(const Vec3d& v) { return Json::array({json_of(v.x), json_of(v.y), json_of(v.z)}); }
template <typename Struct>
requires std::is_aggregate_v<Struct> Json json_of(const Struct& value);
template <typename Row>
Json json_of(const std::vector<Row>& rows) {
    Json array = Json::array();
    for (const Row& row : rows)
        array.push_back(json_of(row));
    return array;
}

/// Visitor of packet_fields.h.
class JsonWriter {
public:
    template <typename Value>
    void operator()(const char* name, const Value& value) {
        json_[name] = json_of(value);
    }
    template <typename Value>
    void required(const char* name, const Value& value) {
        (*this)(name, value);
    }
    void bits(const char* name, std::uint64_t value) { json_[name] = hexadecimal(value); }
    Json take() { return std::move(json_); }

private:
    Json json_ = Json::object();
};

template <typename Struct>
requires std::is_aggregate_v<Struct> Json json_of(const Struct& value) {
    JsonWriter writer;
    fields(writer, value);
    return writer.take();
}

} // namespace linkdig
