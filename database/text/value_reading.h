#pragma once
/// What TableReader's files share about single TOML values.

#include "database/text/table_reader.h"

#include <optional>
#include <string>

namespace linkdig::database {

/// What a value is, for messages: "a text", "an array", "not a number" ...
std::string kind_of(const toml::node& node);
/// Integer or floating-point; nothing if it is neither, or is not finite.
std::optional<double> finite_number(const toml::node& node);
/// [x, y, z], all finite.
std::optional<Vec3d> point_of_node(const toml::node& node);
/// "0 to 1", "at least 0", in the unit in which the value is written: bounds divided by `unit`.
std::string range_text(Range range, double unit);

} // namespace linkdig::database
