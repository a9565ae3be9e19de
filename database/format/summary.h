#pragma once
/// Counts and extents of a visual database, list by list.

#include "database/model/visual_database.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace linkdig::database {

/// Smallest box along the axes of the list's frame that holds every vertex that is not at infinity.
struct Extent {
    Vec3f least{0};
    Vec3f greatest{0};
};

struct ObjectSummary {
    std::uint64_t faces = 0;
    std::uint64_t corners = 0;
    std::uint64_t lights = 0; ///< light points
    std::uint64_t edges = 0;
};

struct ListSummary {
    std::uint64_t faces = 0;
    std::uint64_t corners = 0;
    std::uint64_t smooth_faces = 0;
    std::uint64_t lights = 0; ///< light points
    /// Most faces that can be present at once (database/model/most_at_once.h). A tile's faces not counted.
    std::uint64_t faces_at_most = 0;
    std::uint64_t edges = 0;         ///< database/model/edge_count.h
    std::uint64_t edges_at_most = 0; ///< at once; a tile's not counted
    std::uint64_t runs = 0;
    std::uint64_t leaves = 0;
    std::uint64_t planes = 0;
    std::uint32_t tree_depth = 0; ///< planes on the longest way from the root to a leaf
    bool reaches_infinity = false;
    std::optional<Extent> extent;       ///< none: no vertex at a finite place
    std::vector<std::uint32_t> objects; ///< into VisualDatabase::objects
};

struct LevelSummary {
    std::uint64_t objects = 0;
    std::uint64_t faces = 0;
    std::uint64_t edges = 0; ///< between two places of a list, whichever faces share them
};

struct DatabaseSummary {
    std::vector<ListSummary> lists;     ///< parallel to VisualDatabase::lists
    std::vector<ObjectSummary> objects; ///< parallel to VisualDatabase::objects
    std::vector<LevelSummary> levels;   ///< parallel to VisualDatabase::detail_levels
};

/// The database is sound (validate.h).
DatabaseSummary summarise(const VisualDatabase& database);

} // namespace linkdig::database
