#pragma once
/// The report's first method for the sea (3.1.4): not the sun turns, but every vertex normal, in a predetermined sequence.

#include "host/packet/frame_packet.h"

#include <vector>

namespace linkdig::host {

/// `normals` turned about the vertical by `turned_rad`, into `update.normals`, whose memory is used again.
void turn_normals(const std::vector<Vec3f>& normals, double turned_rad, VertexNormalUpdate& update);

} // namespace linkdig::host
