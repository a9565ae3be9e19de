#pragma once
/// The plane of a face as the screen sees it.

#include "ig/geometry/clip.h"
#include "ig/geometry/projected_face.h"
#include "ig/geometry/view.h"

#include <span>

namespace linkdig::ig {

/// Depth plane of a planar convex polygon in channel coordinates (some of its corners may lie at infinity). A polygon
/// that lies at infinity altogether, has no area, or passes through the eye has 1/z = 0 everywhere: it is infinitely far.
DepthPlane depth_plane(const View& view, std::span<const ClipPoint> polygon);

} // namespace linkdig::ig
