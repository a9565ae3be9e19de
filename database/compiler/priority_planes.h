#pragma once
/// Pass 6: the authored trees of separating planes, of clusters and of groups, and what they leave undecided.

#include "database/compiler/model_object.h"

#include <vector>

namespace linkdig::database {

struct PriorityPlanes {
    std::vector<PlaneNode> nodes;
    std::vector<PriorityGroup> groups;         ///< ascending by number; leaf references are clusters
    std::vector<std::uint32_t> cluster_groups; ///< by cluster, into groups
    std::vector<std::int32_t> cluster_roots;   ///< by cluster; leaf references are object lists
};

/// Reads [[cluster_plane]] and [[group_plane]] tables. Two lists of a cluster with equal numbers, and two
/// static clusters of a group, that no tree puts in order are a tie: an error.
PriorityPlanes read_priority_planes(const AuthoredTables& tables, const Reading& reading);

} // namespace linkdig::database
