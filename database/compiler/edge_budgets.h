#pragma once
/// Pass 8: edges against the budgets that the author has set.

#include "database/compiler/compile.h"
#include "database/compiler/model_object.h"

namespace linkdig::database {

/// Fills in the edges of `statistics`, which has an entry for every list, and reports lists, and the database as a
/// whole, that can have more edges at once than their `edge_budget`.
void check_edge_budgets(const VisualDatabase& database, const Reading& reading,
                        CompileStatistics& statistics);

} // namespace linkdig::database
