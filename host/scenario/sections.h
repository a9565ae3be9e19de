#pragma once
/// Readers of a scenario's sections: each takes its table's keys and reports its mistakes.

#include "database/text/table_reader.h"
#include "host/scenario/scenario.h"

namespace linkdig::host {

using database::Range;
using database::TableReader;

void read_suns(TableReader& root, Scenario& scenario);
void read_ships(TableReader& root, Scenario& scenario);
/// One [[ship]] with its [ship.motion].
ShipSection read_ship(TableReader& reader);
/// [ship.track]; nothing without one.
TrackSection read_track(TableReader& reader);
/// Keys "occulting", "wake", "wake_dwell_s" of a [[ship]], and its [ship.cam].
MethodsSection read_methods(TableReader& ship);
/// Leaders that are no ship, the ship herself, or keep station themselves.
void check_stations(const Scenario& scenario, database::Diagnostics& diagnostics);
void read_own_ship(TableReader& root, Scenario& scenario);
void read_sequences(TableReader& root, Scenario& scenario);
void read_approaches(TableReader& root, Scenario& scenario);
void read_channels(TableReader& root, Scenario& scenario);
void read_sea(TableReader& root, Scenario& scenario);
void read_quays(TableReader& root, Scenario& scenario);
void read_sky(TableReader& root, Scenario& scenario);

/// The name under `key`, with its place.
Name read_name(TableReader& reader, std::string_view key);

/// A direction in degrees clockwise from north (-360 to 360) under `stem`_deg, as a mathematical heading in
/// radians.
double read_heading_rad(TableReader& reader, std::string_view stem);

} // namespace linkdig::host
