#pragma once
/// How a channel looks at the world: rotation, and from tangents to the raster.

#include "host/packet/frame_packet.h"
#include "ig/configuration.h"
#include "ig/geometry/projected_face.h"

namespace linkdig::ig {

/// Channel frame: x right, y up, z along the line of sight, metres.
struct View {
    Vec3d eye_m{0};
    Mat3d channel_from_world{1.0};
    double left = -1, right = 1, bottom = -1, top = 1; ///< frustum tangents
    PictureScale scale;
    bool vertical = false; ///< lines are columns
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
    view.scale.x_scale = 256.0 * raster.width / (view.right - view.left);
    view.scale.x_offset = -view.scale.x_scale * view.left;
    view.scale.y_scale = -256.0 * raster.height / (view.top - view.bottom);
    view.scale.y_offset = -view.scale.y_scale * view.top;
    view.vertical = raster.scan == Scan::vertical;
    return view;
}

} // namespace linkdig::ig
