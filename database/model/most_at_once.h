#pragma once
/// How much of a list can be in the active data base at once: slots and levels of detail exclude each other's parts.

#include "database/model/visual_database.h"

#include <cstdint>
#include <map>
#include <tuple>

namespace linkdig {

/// Counts of things by slot, alternative and level. The order of the map decides nothing but speed.
class MostAtOnce {
public:
    /// `alternative` counts only where there is a slot; `level` is into VisualDatabase::detail_levels, or none.
    void add(std::int32_t slot, std::uint32_t alternative, std::int32_t level, std::uint64_t count) {
        counts_[{level, slot, slot == none ? 0 : alternative}] += count;
    }
    /// Not less than what can be present together: of each slot the alternative with the most, of each detail the level
    /// with the most (two neighbours where they blend, all where they add up).
    std::uint64_t most(const VisualDatabase& database) const;

private:
    /// Level by level, the slots at their most; `none` stands first.
    std::map<std::int32_t, std::uint64_t> by_level() const;
    std::map<std::tuple<std::int32_t, std::int32_t, std::uint32_t>, std::uint64_t> counts_;
};

} // namespace linkdig
