#pragma once
/// The choice of the plane that splits a set of faces.

#include "database/compiler/ordering.h"

#include <optional>
#include <span>
#include <vector>

namespace linkdig::database {

/// Least distance that counts when faces with such coordinates are told apart by a plane that is stored in
/// floats.
double split_tolerance(std::span<const OrderFace> faces);

/// The plane, as a float holds it, that splits the set with the fewest cuts, then most evenly: of the faces'
/// own planes and the axis planes at their borders. Nothing if none makes every part smaller than the set.
std::optional<Plane> splitting_plane(std::span<const OrderFace> faces, double tolerance);

struct EvenPlane {
    Plane plane;
    bool cuts = false; ///< does it cut any face in two?
};

/// For sets too large to compare: the axis plane that cuts few faces and divides the rest evenly, found by
/// counting along sorted borders: n log n. Nothing if none makes every part smaller than the set.
std::optional<EvenPlane> even_plane(std::span<const OrderFace> faces, double tolerance);

} // namespace linkdig::database
