#include "host/packet/json_writer.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

namespace linkdig {

std::string hexadecimal(std::uint64_t bits) { return fmt::format("0x{:x}", bits); }

Json json_of(double value) {
    if (std::isfinite(value)) return value;
    return std::isnan(value) ? "nan" : value > 0.0 ? "inf" : "-inf";
}

Json json_of(float value) {
    if (!std::isfinite(value)) return json_of(static_cast<double>(value));
    char digits[32];
    const auto written = std::to_chars(digits, digits + sizeof(digits), value);
    double shortest = 0.0;
    std::from_chars(digits, written.ptr, shortest);
    // Rounding twice, to double and then to float, could miss the float once in a long while.
    return static_cast<float>(shortest) == value ? shortest : static_cast<double>(value);
}

Json json_of(ShadingMethod method) {
    const auto index = static_cast<std::size_t>(method);
    return index < std::size(shading_method_names) ? Json(shading_method_names[index]) : Json(index);
}

Json json_of(WakeMethod method) {
    const auto index = static_cast<std::size_t>(method);
    return index < std::size(wake_method_names) ? Json(wake_method_names[index]) : Json(index);
}

} // namespace linkdig
