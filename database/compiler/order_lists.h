#pragma once
/// Pass 5: objects become ordered lists of faces.

#include "database/compiler/model_object.h"
#include "database/compiler/ordering.h"

#include <vector>

namespace linkdig::database {

/// Where a face or a light point of FaceOrder (its `source`) came from.
struct FaceSource {
    std::uint32_t object = 0; ///< into the objects
    std::uint32_t face = 0;   ///< into the object's faces, or its lights
    bool is_light = false;
};

struct OrderedList {
    FaceOrder order;
    std::vector<FaceSource> sources;
};

/// One per list of the registry. Ties, and faces that no plane separates, are reported.
std::vector<OrderedList> order_lists(const std::vector<ModelObject>& objects, const Reading& reading);

} // namespace linkdig::database
