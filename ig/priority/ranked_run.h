#pragma once
/// Output of the priority stage: every face run of the channel, front to back.

#include <cstdint>
#include <vector>

namespace linkdig::ig {

struct RankedRun {
    std::uint32_t block = 0; ///< into ActiveDatabase::blocks
    std::uint32_t run = 0;   ///< into that block's runs
};

/// A face's rank is its place in this order: runs as listed, faces as they stand in their run. A lower rank
/// wins.
struct PriorityOrder {
    std::vector<RankedRun> runs;
    std::uint64_t ambiguous = 0; ///< pairs of clusters that no plane decided
};

} // namespace linkdig::ig
