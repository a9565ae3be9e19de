#pragma once
/// The shipped scenario, and a directory with the names of its database.

#include "host/loop/host_loop.h"

namespace linkdig::host {

/// What linkdig compile would leave of first_flight.toml: the names that approach.toml uses, in another
/// order.
NameDirectory first_flight_names();

/// Reads database/scenes/first_flight/approach.toml; fails the test if it cannot.
Scenario first_flight_scenario();

} // namespace linkdig::host
