#pragma once
/// What stands in a database, seen from outside: views of each moving object and each static cluster.

#include "database/model/visual_database.h"
#include "host/packet/frame_packet.h"

#include <cstdint>
#include <string>
#include <vector>

namespace linkdig::tools {

/// Something to look at: all clusters of a moving object, or a static cluster.
struct PreviewSubject {
    std::string name;
    std::int32_t moving_object = none; ///< or none: static
    Vec3d centre_m{0};                 ///< of its contents; of a moving object in its body frame
    Vec3d half_extent_m{0}; ///< of the box about the centre that holds them; zero: no size of its own
    Vec3d stands_m{
        0}; ///< where a moving object is put to be looked at: the origin, or clear of everything static
    std::uint32_t faces = 0; ///< with the first alternative of each slot, and every level of detail
};

/// In the database's order, moving objects first. Clusters around the eye, and those without faces, are no subjects; what
/// reaches to infinity on all sides, as a repeated tile does, is one where nothing static has an end.
std::vector<PreviewSubject> preview_subjects(const VisualDatabase& database);

/// From where a subject is seen: azimuth counter-clockwise from the bow (or from east), both in degrees.
struct PreviewView {
    const char* name;
    double azimuth_deg;
    double elevation_deg;
};
inline constexpr std::uint32_t preview_views = 4;
PreviewView preview_view(std::uint32_t index);

/// The packet that shows the subject alone of all moving objects, upright at the origin or clear of what is static, filling most of a picture of
/// this shape (width / height); slots point at their first alternatives, and levels of detail are at their finest.
FramePacket preview_packet(const VisualDatabase& database, const PreviewSubject& subject,
                           const PreviewView& view, double aspect);

} // namespace linkdig::tools
