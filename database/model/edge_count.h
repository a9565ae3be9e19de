#pragma once
/// How many edges a database has: what the machine's capacity is counted in.

#include "database/model/visual_database.h"

#include <cstdint>
#include <vector>

namespace linkdig {

/// An edge lies between two places of a list, whichever faces share it and however many normals stand at its ends.
struct EdgeCounts {
    std::vector<std::uint32_t> objects; ///< parallel to VisualDatabase::objects
    /// Parallel to VisualDatabase::lists; objects of a list may share edges.
    std::vector<std::uint32_t> lists;
    /// Not less than the edges that can be present at once, and not more than `lists`: sums over the objects of which slots and
    /// levels of detail allow the most together. A tile's edges are not counted.
    std::vector<std::uint32_t> lists_at_most;
};

EdgeCounts count_edges(const VisualDatabase& database);

} // namespace linkdig
