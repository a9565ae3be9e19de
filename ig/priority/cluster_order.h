#pragma once
/// Order of the clusters of one priority group: static ones by the group's planes, moving ones put in
/// between.

#include "ig/active/face_block.h"
#include "ig/priority/prioritise.h"

namespace linkdig::ig {

/// Appends the group's visible clusters to `scratch.clusters`, nearest first as seen from `eye_m` (world).
/// Returns how many pairs no plane decided; those go by the distance of their reference points.
std::uint64_t order_clusters(const ActiveDatabase& active, std::uint32_t group, const Vec3d& eye_m,
                             PriorityScratch& scratch);

} // namespace linkdig::ig
