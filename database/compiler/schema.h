#pragma once
/// The authoring language's tables and keys, as the compiler's own readers ask for them: nothing here is typed twice.

#include "database/text/key_log.h"

#include <string>
#include <vector>

namespace linkdig::database {

/// Every table that an authoring file may hold, with every key: what the readers ask for while they read one table of each
/// kind. Tables whose keys are the author's own names (vertices, sides, materials) are left out.
std::vector<TableUse> schema();

/// docs/authoring-reference.md.
std::string schema_markdown();

} // namespace linkdig::database
