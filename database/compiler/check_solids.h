#pragma once
/// Solids: of faces that close, which side is the front is no matter of taste.

#include "database/compiler/model_object.h"

namespace linkdig::database {

/// Reports a solid that is inside out, and each face that is turned against the other faces of its solid. A solid is what
/// faces of one object enclose that meet in twos at every edge; two-sided faces and meshes are left alone, and what stands
/// around the eye (a sky) is seen from inside.
void check_solids(const std::vector<ModelObject>& objects, const Reading& reading);

} // namespace linkdig::database
