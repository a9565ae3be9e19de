#pragma once
/// std::floor() as whole numbers: it is a call on processors of the baseline, and geometry and edges ask for millions.

#include <cstdint>

namespace linkdig::ig {

/// The greatest whole number that is not above `value`. |value| < 2^62.
inline std::int64_t floor_of(double value) {
    const auto whole = static_cast<std::int64_t>(value);
    return whole - (static_cast<double>(whole) > value ? 1 : 0);
}

} // namespace linkdig::ig
