#pragma once
/// Stage 2, priority: numbers, groups, clusters and planes put every face run of a channel in order, front to
/// back.

#include "host/packet/frame_packet.h"
#include "ig/active/face_block.h"
#include "ig/priority/ranked_run.h"

namespace linkdig::ig {

/// Working storage that keeps its capacity from frame to frame.
struct PriorityScratch {
    std::vector<std::uint32_t> clusters;            ///< in order
    std::vector<std::vector<std::uint32_t>> moving; ///< per depth of the recursion
    std::vector<std::uint32_t> order_of_list;       ///< place in its cluster's tree, parallel to the lists
    std::vector<std::uint32_t> blocks;              ///< of one cluster
};

void prioritise(const ActiveDatabase& active, const ChannelView& channel, PriorityScratch& scratch,
                PriorityOrder& order);

} // namespace linkdig::ig
