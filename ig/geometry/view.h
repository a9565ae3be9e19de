#pragma once
/// How a channel looks at the world: rotation, and from tangents to the raster.

#include "host/packet/frame_packet.h"
#include "ig/configuration.h"

namespace linkdig::ig {

/// Channel frame: x along the elements' screen axis... right, y up, z along the line of sight, metres.
///
/// A point (x, y, z) lands on the raster at
///   line    = line_scale * (line axis tangent) + line_offset
///   element = element_scale * (element axis tangent) + element_offset
/// with tangents x/z and y/z, in 1/256 pixel; which of them runs along the lines is the scan's choice.
struct View {
    Vec3d eye_m{0};
    Mat3d channel_from_world{1.0};
    double left = -1, right = 1, bottom = -1, top = 1; ///< frustum tangents
    double x_scale = 1, x_offset = 0; ///< picture column in 1/256 pixel = x_scale * x/z + x_offset
    double y_scale = 1, y_offset = 0; ///< picture row, down
    bool vertical = false;            ///< lines are columns
};

inline View view_of(const ChannelView& channel, const Raster& raster) {
    const Mat3d body = world_from_body(channel.attitude);
    View view;
    view.eye_m = channel.eye_m;
    // Rows of channel_from_world are the channel's axes: right = -port, up, forward.
    view.channel_from_world = glm::transpose(Mat3d(-body[1], body[2], body[0]));
    view.left = channel.left_tangent;
    view.right = channel.right_tangent;
    view.bottom = channel.bottom_tangent;
    view.top = channel.top_tangent;
    view.x_scale = 256.0 * raster.width / (view.right - view.left);
    view.x_offset = -view.x_scale * view.left;
    view.y_scale = -256.0 * raster.height / (view.top - view.bottom);
    view.y_offset = -view.y_scale * view.top;
    view.vertical = raster.scan == Scan::vertical;
    return view;
}

} // namespace linkdig::ig
