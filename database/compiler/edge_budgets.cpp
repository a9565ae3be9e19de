#include "database/compiler/edge_budgets.h"

#include "database/model/edge_count.h"

#include <fmt/format.h>

namespace linkdig::database {

void check_edge_budgets(const VisualDatabase& database, const Reading& reading,
                        CompileStatistics& statistics) {
    const Registry& registry = *reading.registry;
    const EdgeCounts counts = count_edges(database);
    for (std::size_t i = 0; i < statistics.lists.size(); ++i) {
        ListStatistics& list = statistics.lists[i];
        list.edges = counts.lists[i];
        list.edges_at_once = counts.lists_at_most[i];
        list.edge_budget = registry.lists[i].edge_budget;
        if (list.edge_budget != 0 && list.edges_at_once > list.edge_budget)
            reading.error(registry.lists[i].at,
                          fmt::format("object list \"{}\" has up to {} edges at once; expected at most its "
                                      "edge_budget, {}",
                                      list.name, list.edges_at_once, list.edge_budget));
    }
    statistics.edge_budget = registry.edge_budget;
    const std::uint32_t all = statistics.total().edges_at_once;
    if (registry.edge_budget != 0 && all > registry.edge_budget)
        reading.error(
            registry.edge_budget_at,
            fmt::format("the database has up to {} edges at once; expected at most its edge_budget, {}", all,
                        registry.edge_budget));
}

} // namespace linkdig::database
