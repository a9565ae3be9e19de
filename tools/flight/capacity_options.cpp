#include "tools/flight/capacity_options.h"
#include "tools/flight/number_options.h"

#include <fmt/format.h>

#include <cstdio>
#include <string>

namespace linkdig::tools {

void add_capacity_options(CLI::App& app, ig::Capacity& capacity) {
    app.add_option(
           "--edges", capacity.edges,
           "Edges that the machine takes of one frame, all channels; beyond it detail is shed. 0: no limit")
        ->transform(whole_number())
        ->capture_default_str();
    app.add_option("--crossings", capacity.crossings_on_a_line, "Edges that it takes on one line; likewise")
        ->transform(whole_number())
        ->capture_default_str();
    app.add_option("--lights", capacity.light_points,
                   "Light points that it takes of one frame, all channels; beyond it strings grow thin")
        ->transform(whole_number())
        ->capture_default_str();
}

void print_overload(const FlightCosts& costs) {
    if (costs.over_limit == 0 && costs.shed == 0) return;
    fmt::print(stderr, "overload: {} frames beyond a limit, {} drawn with less detail; at the most:\n",
               costs.over_limit, costs.shed);
    for (const std::string& line : overload_text(costs.worst))
        fmt::print(stderr, "  {}\n", line);
}

} // namespace linkdig::tools
