#include "host/scenario/bind_methods.h"

#include <fmt/format.h>

#include <algorithm>

namespace linkdig::host {

namespace {

using database::NameDirectory;

MaybeSlot slot_of(const NameDirectory& directory, const std::string& name) {
    const auto found = directory.find_slot(name);
    if (!found) return std::nullopt;
    return BoundSlot{*found, directory.slots[*found].alternatives};
}

/// A slot with nothing as alternative 0 and something behind it.
std::string without(const MaybeSlot& slot, const std::string& name, std::uint32_t alternatives) {
    if (!slot) return fmt::format("the slot \"{}\"", name);
    if (slot->alternatives < alternatives)
        return fmt::format("{} alternatives in the slot \"{}\" (it has {})", alternatives, name,
                           slot->alternatives);
    return {};
}

std::optional<std::uint32_t> either_list(const NameDirectory& directory, const std::string& first,
                                         const std::string& second) {
    const auto found = directory.find_list(first);
    return found ? found : directory.find_list(second);
}

std::string without_list(const std::optional<std::uint32_t>& list, const std::string& name) {
    return list ? std::string() : fmt::format("the list \"{}\"", name);
}

std::string without_light(const ShipSlots& slots) {
    return slots.wake_light ? std::string() : "the colour \"wake light\"";
}

std::string first_of(std::initializer_list<std::string> clauses) {
    for (const std::string& clause : clauses)
        if (!clause.empty()) return clause;
    return {};
}

void bind_cluster(const std::string& ship, const NameDirectory& directory, ShipSlots& slots) {
    const auto row = directory.find_moving_object(ship);
    const auto sea = directory.find_cluster("sea");
    if (!row || !sea) return;
    const auto rides = [&](const NameDirectory::Cluster& each) {
        return each.moving_object == static_cast<std::int32_t>(*row);
    };
    const auto cluster = std::ranges::find_if(directory.clusters, rides);
    if (cluster == directory.clusters.end()) return;
    slots.cluster = static_cast<std::uint32_t>(cluster - directory.clusters.begin());
    slots.number_behind_sea = directory.clusters[*sea].priority; // of equal numbers it comes after the group
}

} // namespace

ShipSlots ship_slots(const std::string& ship, const NameDirectory& directory) {
    const auto own = [&](const char* name) { return slot_of(directory, ship + "." + name); };
    ShipSlots slots{.hull_below = own("hull_below"),
                    .box = own("box"),
                    .wedge_bow = own("wedge_bow"),
                    .wedge_stern = own("wedge_stern"),
                    .bow_wake_port = own("bow_wake_port"),
                    .bow_wake_starboard = own("bow_wake_starboard"),
                    .solid_bow_wake = own("solid_bow_wake"),
                    .v_wake = own("v_wake"),
                    .churn = own("churn"),
                    .cam = own("cam"),
                    .lights = own("lights"),
                    .cam_port = directory.find_moving_object(ship + ".cam_port"),
                    .cam_starboard = directory.find_moving_object(ship + ".cam_starboard"),
                    .moving_object = directory.find_moving_object(ship),
                    .kelvin = directory.find_list(ship + ".kelvin"),
                    .wave_particles = directory.find_list(ship + ".wave_particles"),
                    .hull = directory.find_list(ship + ".hull_below"),
                    .hull_above = either_list(directory, ship + ".topsides", ship + ".ship"),
                    .wake_light = directory.find_colour("wake light"),
                    .cluster = {},
                    .number_behind_sea = {}};
    // LPH-2's bow wake is older than the others' and has no ship in its name.
    if (!slots.bow_wake_port && ship == "lph2") slots.bow_wake_port = slot_of(directory, "bow_wake_port");
    if (!slots.bow_wake_starboard && ship == "lph2")
        slots.bow_wake_starboard = slot_of(directory, "bow_wake_starboard");
    bind_cluster(ship, directory, slots);
    return slots;
}

std::string lacking(const ShipSlots& slots, const std::string& ship, Occulting occulting) {
    const std::string hull = without(slots.hull_below, ship + ".hull_below", 2);
    switch (occulting) {
    case Occulting::none:
        return first_of({hull, slots.cluster ? "" : "a cluster \"sea\" behind which the ship could go"});
    case Occulting::waterline:
        return {};
    case Occulting::priority:
        return hull;
    case Occulting::box:
        return first_of({hull, without(slots.box, ship + ".box", 2)});
    case Occulting::fitted_box:
        return first_of({hull, without(slots.box, ship + ".box", 3)});
    case Occulting::wedges:
        return first_of({without(slots.wedge_bow, ship + ".wedge_bow", 2),
                         without(slots.wedge_stern, ship + ".wedge_stern", 2)});
    }
    return {};
}

std::string lacking(const ShipSlots& slots, const std::string& ship, Wake wake) {
    switch (wake) {
    case Wake::white_v:
        return without(slots.v_wake, ship + ".v_wake", 2);
    case Wake::blended_v:
        return without(slots.v_wake, ship + ".v_wake", 3);
    case Wake::cam:
        if (!slots.cam_port || !slots.cam_starboard)
            return fmt::format("the moving objects \"{0}.cam_port\" and \"{0}.cam_starboard\"", ship);
        return without(slots.cam, ship + ".cam", 2);
    case Wake::face_substitution:
        return first_of({without(slots.bow_wake_port, ship + ".bow_wake_port", 2),
                         without(slots.bow_wake_starboard, ship + ".bow_wake_starboard", 2)});
    case Wake::solid:
        return without(slots.solid_bow_wake, ship + ".solid_bow_wake", 2);
    case Wake::churned:
        return without(slots.churn, ship + ".churn", 2);
    case Wake::kelvin:
        return first_of({without_list(slots.kelvin, ship + ".kelvin"), without_light(slots)});
    case Wake::wave_particles:
        return first_of({without_list(slots.wave_particles, ship + ".wave_particles"),
                         without_list(slots.hull, ship + ".hull_below"), without_light(slots)});
    }
    return {};
}

void check_methods(const ShipSection& ship, const ShipSlots& slots, database::Diagnostics& diagnostics) {
    const MethodsSection& methods = ship.methods;
    const auto tell = [&](const database::SourceLocation& at, const char* method, const std::string& lacks) {
        if (!lacks.empty())
            diagnostics.error(at,
                              fmt::format("\"{}\" cannot be shown: the database lacks {}", method, lacks));
    };
    const std::string& name = ship.moving_object.text;
    if (methods.occulting)
        tell(methods.occulting_at, occulting_names[static_cast<std::size_t>(*methods.occulting)],
             lacking(slots, name, *methods.occulting));
    if (methods.lights == ShipLights::on)
        tell(methods.lights_at, "lights", without(slots.lights, name + ".lights", 2));
    if (!methods.wakes) return;
    for (std::size_t i = 0; i < wake_count; ++i)
        if ((*methods.wakes)[i])
            tell(methods.wake_at, wake_names[i], lacking(slots, name, static_cast<Wake>(i)));
    const auto on = [&](Wake wake) { return (*methods.wakes)[static_cast<std::size_t>(wake)]; };
    if (on(Wake::white_v) && on(Wake::blended_v))
        diagnostics.error(methods.wake_at,
                          "\"wake\" names both white_v and blended_v, which stand in one slot; expected one");
    const auto always = [](const MaybeSlot& slot) { return slot && slot->alternatives == 28; };
    if (!on(Wake::face_substitution) && (always(slots.bow_wake_port) || always(slots.bow_wake_starboard)))
        diagnostics.error(methods.wake_at, "\"wake\" leaves face_substitution away, but the database's bow "
                                           "wake has no alternative that is nothing");
}

std::optional<std::uint32_t> sea_tile(const NameDirectory& directory) {
    const auto list = directory.find_list("sea");
    if (!list) return std::nullopt;
    const auto found = std::ranges::find(directory.tiles, *list, &NameDirectory::Tile::list);
    if (found == directory.tiles.end()) return std::nullopt;
    return static_cast<std::uint32_t>(found - directory.tiles.begin());
}

} // namespace linkdig::host
