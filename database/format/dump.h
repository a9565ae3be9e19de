#pragma once
/// What is in a visual database, for people and programs: `linkdig inspect`.

#include "database/model/visual_database.h"

#include <cstdint>
#include <string>

namespace linkdig::database {

/// A JSON tree: totals; per list its light, extent, face counts, the most faces that can be present at once
/// (its budget: one alternative per slot), depth of its plane tree, and its objects. Indented, with a final
/// new line. The database is sound (validate.h).
std::string dump_json(const VisualDatabase& database, std::uint64_t id);

/// The same as lines of text, a line per list, and with `objects` a line per object below it.
std::string dump_text(const VisualDatabase& database, std::uint64_t id, bool objects = false);

} // namespace linkdig::database
