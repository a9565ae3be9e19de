#pragma once
/// Names become indices: the second step of reading a scenario, when its visual database is known.

#include "database/format/name_directory.h"
#include "host/scenario/bind_methods.h"
#include "host/scenario/scenario.h"

namespace linkdig::host {

using database::NameDirectory;

/// Indices into the tables of the visual database, parallel to the vectors of the scenario.
struct Binding {
    std::vector<std::uint32_t> suns;
    std::vector<std::uint32_t> ships; ///< moving objects
    std::vector<std::uint32_t> slots;
    std::vector<std::uint32_t> slot_alternatives;
    std::vector<std::uint32_t> sky_lists;
    std::vector<std::uint32_t> sky_bands;  ///< colour codes
    std::vector<ShipSlots> ship_slots;     ///< parallel to the ships
    std::optional<std::uint32_t> sea_tile; ///< into NameDirectory::tiles
    std::uint32_t sun_count = 0;           ///< rows that a packet for this database has
    std::uint32_t moving_object_count = 0;
};

/// Looks up all names. Unknown ones, ships that are named without a [[ship]], and suns of the database that the scenario says
/// nothing about, are reported where they stand in the scenario; the binding may be used only if nothing was.
Binding bind(const Scenario& scenario, const NameDirectory& directory, database::Diagnostics& diagnostics);

} // namespace linkdig::host
