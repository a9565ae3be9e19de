#include "ig/priority/prioritise.h"

#include "ig/priority/cluster_order.h"
#include "ig/priority/plane_tree.h"

#include <algorithm>
#include <limits>

namespace linkdig::ig {

namespace {

/// The eye in the frame that a cluster's plane hangs in.
Vec3d eye_in_cluster(const ClusterPose& pose, bool waterline, const Vec3d& eye_m) {
    return waterline ? glm::transpose(pose.world_from_waterline) * (eye_m - pose.waterline_origin_m)
                     : glm::transpose(pose.world_from_body) * (eye_m - pose.body_origin_m);
}

/// Blocks of a cluster into scratch.blocks: by number, equal numbers by the cluster's planes.
void order_blocks(const ActiveDatabase& active, std::uint32_t cluster, const Vec3d& eye_m,
                  PriorityScratch& scratch) {
    const VisualDatabase& database = *active.database;
    const Vec3d eye_from_body = eye_in_cluster(active.poses[cluster], false, eye_m);
    const Vec3d eye_from_waterline = eye_in_cluster(active.poses[cluster], true, eye_m);
    scratch.order_of_list.assign(database.lists.size(), 0);
    std::uint32_t place = 0;
    walk_plane_tree(
        database.planes, database.clusters[cluster].root,
        [&](const PlaneNode& node) {
            return in_front_of(node, node.waterline != 0 ? eye_from_waterline : eye_from_body);
        },
        [&](std::uint32_t list) { scratch.order_of_list[list] = ++place; });

    scratch.blocks.clear();
    for (std::uint32_t b = 0; b < active.blocks.size(); ++b) {
        if (active.blocks[b].cluster == cluster) scratch.blocks.push_back(b);
    }
    std::sort(scratch.blocks.begin(), scratch.blocks.end(), [&](std::uint32_t a, std::uint32_t b) {
        const FaceBlock& first = active.blocks[a];
        const FaceBlock& second = active.blocks[b];
        if (first.number != second.number) return first.number < second.number;
        const std::uint32_t place_a = scratch.order_of_list[first.list];
        const std::uint32_t place_b = scratch.order_of_list[second.list];
        return place_a != place_b ? place_a < place_b : a < b;
    });
}

void put_runs(const ActiveDatabase& active, std::uint32_t block_index, const Vec3d& eye_m,
              PriorityOrder& order) {
    const FaceBlock& block = active.blocks[block_index];
    const Vec3d eye =
        block.at_eye ? Vec3d(0) : glm::transpose(block.world_from_list) * (eye_m - block.origin_m);
    walk_plane_tree(
        active.database->planes, block.root, [&](const PlaneNode& node) { return in_front_of(node, eye); },
        [&](std::uint32_t leaf_number) {
            const RunLeaf& leaf = block.leaves[leaf_number];
            for (std::uint32_t run = leaf.first_run; run < leaf.first_run + leaf.run_count; ++run) {
                if (present(block.runs[run], active)) order.runs.push_back({block_index, run});
            }
        });
}

void put_cluster(const ActiveDatabase& active, std::uint32_t cluster, const Vec3d& eye_m,
                 PriorityScratch& scratch, PriorityOrder& order) {
    order_blocks(active, cluster, eye_m, scratch);
    for (const std::uint32_t block : scratch.blocks)
        put_runs(active, block, eye_m, order);
}

bool has_left_its_group(const ActiveDatabase& active, std::uint32_t cluster) {
    return std::ranges::find(active.moved, cluster, &ClusterPriority::cluster) != active.moved.end();
}

} // namespace

void prioritise(const ActiveDatabase& active, const ChannelView& channel, PriorityScratch& scratch,
                PriorityOrder& order) {
    order.runs.clear();
    order.ambiguous = 0;
    const auto groups = static_cast<std::uint32_t>(active.database->groups.size());
    std::size_t moved = 0;
    const auto put_moved_before = [&](std::int64_t number) {
        for (; moved < active.moved.size() && active.moved[moved].number < number; ++moved)
            if (active.poses[active.moved[moved].cluster].visible)
                put_cluster(active, active.moved[moved].cluster, channel.eye_m, scratch, order);
    };
    for (std::uint32_t group = 0; group < groups; ++group) { // ascending by number: the lower wins
        put_moved_before(active.database->groups[group].number);
        scratch.clusters.clear();
        order.ambiguous += order_clusters(active, group, channel.eye_m, scratch);
        for (const std::uint32_t cluster : scratch.clusters)
            if (!has_left_its_group(active, cluster))
                put_cluster(active, cluster, channel.eye_m, scratch, order);
    }
    put_moved_before(std::numeric_limits<std::int64_t>::max());
}

} // namespace linkdig::ig
