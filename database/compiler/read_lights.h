#pragma once
/// Light points and strings of them: [[object.light]] and [[object.light_string]].

#include "database/compiler/model_object.h"

#include <optional>

namespace linkdig::database {

/// Adds the light points of an [[object]] table. `inherited`: the object's colour, for those that name none.
void read_lights(TableReader& object_reader, std::uint16_t file, const Reading& reading,
                 std::optional<std::uint16_t> inherited, ModelObject& object);

/// Most light points of one string.
inline constexpr std::int64_t most_lights = 100000;

} // namespace linkdig::database
