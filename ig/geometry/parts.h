#pragma once
/// A channel's faces in parts, so that threads project a part each; and the parts joined again. No face depends on another,
/// so that the whole is the same however it was cut.

#include "ig/active/face_block.h"
#include "ig/geometry/projected_face.h"
#include "ig/priority/ranked_run.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace linkdig::ig {

/// Before a face of the order: `face` counts inside the run. Of a run of n faces, n is never used, but 0 of the next.
struct FacePlace {
    std::size_t run = 0; ///< into PriorityOrder::runs
    std::uint32_t face = 0;
    bool operator==(const FacePlace&) const = default;
};

/// Faces [from, to) of an order.
struct OrderPart {
    FacePlace from;
    FacePlace to;
};

/// All of an order.
OrderPart whole_of(const PriorityOrder& order);

/// Faces of an order, before any is looked at.
std::uint64_t count_faces(const ActiveDatabase& active, const PriorityOrder& order);

/// Cuts an order of so many faces into this many consecutive parts of about the same number of faces; the last ones may be empty.
void cut_order(const ActiveDatabase& active, const PriorityOrder& order, std::uint64_t faces,
               std::size_t parts, std::vector<OrderPart>& cut);

/// Adds what the next part has projected behind what is there.
void append(const ProjectedFaces& part, ProjectedFaces& all);

} // namespace linkdig::ig
