#pragma once
/// The machine's limits on the command line, and what they cost the picture.

#include "ig/configuration.h"
#include "tools/flight/flight.h"

#include <CLI/CLI.hpp>

namespace linkdig::tools {

/// --edges, --crossings and --lights, into `capacity`.
void add_capacity_options(CLI::App& app, ig::Capacity& capacity);

/// To stderr: how many frames were beyond a limit or drawn with less, and what was left out. Nothing if none was.
void print_overload(const FlightCosts& costs);

} // namespace linkdig::tools
