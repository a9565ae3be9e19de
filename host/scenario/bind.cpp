#include "host/scenario/bind.h"

#include <fmt/format.h>

#include <algorithm>

namespace linkdig::host {

namespace {

struct Lookup {
    const char* kind;
    const std::vector<std::string>& candidates;
    database::Diagnostics& diagnostics;

    std::uint32_t index(const Name& name, std::optional<std::uint32_t> found) const {
        if (found) return *found;
        const std::string closest = database::suggestion(name.text, candidates);
        const std::string advice = !closest.empty() ? fmt::format("did you mean {}?", closest)
                                   : candidates.empty()
                                       ? "it has none"
                                       : fmt::format("it has: {}", fmt::join(candidates, ", "));
        diagnostics.error(name.at, fmt::format("the database has no {} \"{}\"; {}", kind, name.text, advice));
        return 0;
    }
};

void bind_suns(const Scenario& scenario, const NameDirectory& directory, Binding& binding,
               database::Diagnostics& diagnostics) {
    const Lookup lookup{"sun", directory.suns, diagnostics};
    for (const SunSection& each : scenario.suns)
        binding.suns.push_back(lookup.index(each.sun, directory.find_sun(each.sun.text)));
    for (const std::string& name : directory.suns) {
        const auto same = [&](const SunSection& each) { return each.sun.text == name; };
        if (std::ranges::none_of(scenario.suns, same))
            diagnostics.error(
                {scenario.path, 0, 0},
                fmt::format("the database's sun \"{0}\" stands nowhere; expected [suns.{0}]", name));
    }
}

/// What goes by a ship names a [[ship]] of the scenario. Said here and not when the scenario is read: if it is the ship's own name
/// that is wrong, the database knows it, and the ship is told alone.
void check_ship_names(const Scenario& scenario, const NameDirectory& directory,
                      database::Diagnostics& diagnostics) {
    const auto is_unknown = [&](const ShipSection& ship) {
        return !directory.find_moving_object(ship.moving_object.text);
    };
    const bool a_ship_is_unknown = std::ranges::any_of(scenario.ships, is_unknown);
    const auto check = [&](const Name& name) {
        const auto same = [&](const ShipSection& ship) { return ship.moving_object.text == name.text; };
        if (name.text.empty() || std::ranges::any_of(scenario.ships, same)) return;
        if (a_ship_is_unknown && directory.find_moving_object(name.text)) return; // that ship is meant
        diagnostics.error(name.at, fmt::format("no [[ship]] has the moving object \"{}\"", name.text));
    };
    for (const ShipSection& ship : scenario.ships)
        check(ship.track.leader);
    if (scenario.own_ship.beside) check(*scenario.own_ship.beside);
    for (const ApproachSection& approach : scenario.approaches)
        check(approach.ship);
}

template <typename Named>
std::vector<std::string> names_of(const std::vector<Named>& things) {
    std::vector<std::string> names;
    names.reserve(things.size());
    for (const Named& each : things)
        names.push_back(each.name);
    return names;
}

} // namespace

Binding bind(const Scenario& scenario, const NameDirectory& directory, database::Diagnostics& diagnostics) {
    Binding binding;
    binding.sun_count = static_cast<std::uint32_t>(directory.suns.size());
    binding.moving_object_count = static_cast<std::uint32_t>(directory.moving_objects.size());
    bind_suns(scenario, directory, binding, diagnostics);
    const Lookup movers{"moving object", directory.moving_objects, diagnostics};
    for (const ShipSection& each : scenario.ships) {
        binding.ships.push_back(
            movers.index(each.moving_object, directory.find_moving_object(each.moving_object.text)));
        binding.ship_slots.push_back(ship_slots(each.moving_object.text, directory));
        check_methods(each, binding.ship_slots.back(), diagnostics);
    }
    check_ship_names(scenario, directory, diagnostics);
    const std::vector<std::string> slots = names_of(directory.slots);
    const Lookup lookup{"substitution slot", slots, diagnostics};
    for (const SequenceSection& each : scenario.sequences) {
        const auto found = directory.find_slot(each.slot.text);
        binding.slots.push_back(lookup.index(each.slot, found));
        binding.slot_alternatives.push_back(found ? directory.slots[*found].alternatives : 1);
    }
    const std::vector<std::string> lists = names_of(directory.lists);
    const Lookup listed{"object list", lists, diagnostics};
    binding.sea_tile = sea_tile(directory);
    if (scenario.sea_method == SeaMethod::normals && !binding.sea_tile)
        diagnostics.error(
            scenario.sea_method_at,
            "\"normals\" cannot be shown: the database lacks an object list \"sea\" that repeats a tile");
    for (const Name& each : scenario.sky_lists)
        binding.sky_lists.push_back(listed.index(each, directory.find_list(each.text)));
    const Lookup coloured{"colour", directory.colours, diagnostics};
    for (const Name& each : scenario.sky_bands)
        binding.sky_bands.push_back(coloured.index(each, directory.find_colour(each.text)));
    return binding;
}

} // namespace linkdig::host
