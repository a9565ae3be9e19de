#pragma once
/// The database compiler: an authoring file and what it includes become a visual database, or a list of
/// mistakes.

#include "database/model/visual_database.h"
#include "database/text/diagnostic.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace linkdig::database {

struct ListStatistics {
    std::string name;
    std::uint32_t objects = 0;
    std::uint32_t faces = 0;
    std::uint32_t faces_at_once = 0; ///< most that are present together: one alternative of each slot
    std::uint32_t edges = 0;         ///< between two places, whoever uses them
    std::uint32_t edges_at_once = 0; ///< not less than can be present together (database/model/edge_count.h)
    std::uint32_t edge_budget = 0;   ///< set by the author; 0: none
    std::uint32_t vertices = 0;
    std::uint32_t planes = 0; ///< nodes of the list's tree
    std::uint32_t splits = 0; ///< times that a plane cut a face in two
    std::uint32_t lights = 0; ///< light points
    std::uint32_t runs = 0;
};

/// What became of a [[mesh]] table's file.
struct MeshStatistics {
    std::string name;
    std::uint32_t objects = 0;
    std::uint32_t polygons = 0;     ///< in the file
    std::uint32_t faces = 0;        ///< made of them, before the ordering pass cuts any
    std::uint32_t cut = 0;          ///< polygons that were not planar or not convex, and became triangles
    std::uint32_t without_area = 0; ///< left out: nothing of them would show
    std::uint32_t doubled = 0;      ///< left out: one with the same corners stands already
};

struct CompileStatistics {
    std::vector<ListStatistics> lists; ///< parallel to VisualDatabase::lists
    std::vector<MeshStatistics> meshes;
    std::uint32_t priority_planes = 0; ///< nodes of the clusters' and groups' trees
    std::uint32_t edge_budget = 0;     ///< of the whole database; 0: none
    /// Sums over the lists; the name stays empty.
    ListStatistics total() const;
};

struct CompileResult {
    std::optional<VisualDatabase> database; ///< absent if there is any mistake
    Diagnostics diagnostics;
    CompileStatistics statistics;
    /// Every file that the result depends on, as opened, in the order of reading; those that could not be read too.
    std::vector<std::string> files;
};

/// Compiles the file at `path`. All mistakes are told at once. The result depends on the files' contents and
/// their places relative to the root file only.
CompileResult compile_file(const std::string& path);

} // namespace linkdig::database
