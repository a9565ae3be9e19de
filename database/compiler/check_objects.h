#pragma once
/// Pass 4: the checks that need whole objects. What fails is reported and taken out, so that later passes see
/// only what they can work with.

#include "database/compiler/model_object.h"

namespace linkdig::database {

/// Coordinates of authored points, metres: beyond it a float keeps no metres.
inline constexpr double largest_coordinate_m = 1e7;

/// Faces: bounded, planar, convex, with an area. Sets the plane of each face that stays.
void check_faces(std::vector<ModelObject>& objects, const Reading& reading);

/// Slots: the objects cover exactly the alternatives that the slot declares, without an empty first one.
void check_slots(const std::vector<ModelObject>& objects, const Reading& reading);

/// Levels of detail: every level has an object, and no object a level that its detail lacks.
void check_levels(const std::vector<ModelObject>& objects, const Reading& reading);
/// Gives every vertex that has no normal the average of its faces' normals in the object (report, Appendix I:
/// "averaged to produce a vector that points in a direction median to the others"), as a unit vector.
void average_normals(ModelObject& object);

} // namespace linkdig::database
