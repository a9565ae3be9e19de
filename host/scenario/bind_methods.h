#pragma once
/// What a database offers for the report's methods, by the names of its slots: SHIP.box, SHIP.v_wake, ...

#include "database/format/name_directory.h"
#include "host/scenario/scenario.h"

#include <optional>

namespace linkdig::host {

/// A slot and how many alternatives it has.
struct BoundSlot {
    std::uint32_t slot = 0;
    std::uint32_t alternatives = 0;
};
using MaybeSlot = std::optional<BoundSlot>;

/// A ship's slots; alternative 0 is nothing, except where a bow wake has exactly its 28 faces.
struct ShipSlots {
    MaybeSlot hull_below;
    MaybeSlot box; ///< 1 plain, 2 of the hull's shape
    MaybeSlot wedge_bow, wedge_stern;
    MaybeSlot bow_wake_port, bow_wake_starboard;
    MaybeSlot solid_bow_wake;
    MaybeSlot v_wake; ///< 1 white, 2 blended
    MaybeSlot churn;
    MaybeSlot cam;
    MaybeSlot lights;
    std::optional<std::uint32_t> cam_port, cam_starboard; ///< moving objects
    std::optional<std::uint32_t> moving_object;           ///< the ship's own row
    std::optional<std::uint32_t> kelvin, wave_particles;  ///< lists that the machine fills
    std::optional<std::uint32_t> hull;                    ///< the list of what is below the waterline
    std::optional<std::uint32_t> hull_above;              ///< and of her sides above it
    std::optional<std::uint32_t> wake_light;              ///< colour code of their faces
    std::optional<std::uint32_t> cluster;                 ///< that rides on the ship
    std::optional<std::int32_t> number_behind_sea;        ///< a cluster of this number comes after the sea
};

ShipSlots ship_slots(const std::string& ship, const database::NameDirectory& directory);

/// What the database lacks for a method, as a clause for a message; empty: nothing.
std::string lacking(const ShipSlots& slots, const std::string& ship, Occulting occulting);
std::string lacking(const ShipSlots& slots, const std::string& ship, Wake wake);

/// Reports the scenario's methods for which the database lacks something, where the scenario names them.
void check_methods(const ShipSection& ship, const ShipSlots& slots, database::Diagnostics& diagnostics);

/// The tile whose normals the host may turn: that of the list "sea".
std::optional<std::uint32_t> sea_tile(const database::NameDirectory& directory);

} // namespace linkdig::host
