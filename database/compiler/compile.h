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
    std::uint32_t vertices = 0;
    std::uint32_t planes = 0; ///< nodes of the list's tree
    std::uint32_t splits = 0; ///< times that a plane cut a face in two
    std::uint32_t lights = 0; ///< light points
    std::uint32_t runs = 0;
};

struct CompileStatistics {
    std::vector<ListStatistics> lists; ///< parallel to VisualDatabase::lists
    std::uint32_t priority_planes = 0; ///< nodes of the clusters' and groups' trees
    /// Sums over the lists; the name stays empty.
    ListStatistics total() const;
};

struct CompileResult {
    std::optional<VisualDatabase> database; ///< absent if there is any mistake
    Diagnostics diagnostics;
    CompileStatistics statistics;
};

/// Compiles the file at `path`. All mistakes are told at once. The result depends on the files' contents and
/// their places relative to the root file only.
CompileResult compile_file(const std::string& path);

} // namespace linkdig::database
