#pragma once
/// A frame's faces for the ray caster: from the visual database and the packet alone. This is the check's only reader of
/// the database; it shares no code with ig/active, ig/priority and ig/geometry, so that it cannot share their mistakes.

#include "database/model/visual_database.h"
#include "host/packet/frame_packet.h"

#include <cstdint>
#include <vector>

namespace linkdig::tools {

/// Range of what lies at infinity, metres: beyond everything else.
inline constexpr double endless_m = 1e30;

/// A face, or the ground that a repeated tile covers. Positions are relative to the scene's eye, world axes.
struct CastFace {
    std::uint32_t list = 0;
    std::uint32_t object = 0;
    std::int32_t face = none; ///< into VisualDatabase::faces; none: the ground of the list's tile
    bool two_sided = false;
    bool endless = false; ///< every corner lies at infinity
    Vec3d normal{0};      ///< unit, from the corners
    double distance_m =
        0; ///< of the face's plane from the eye along the normal: negative if the eye is in front
    std::vector<Vec3d> corners{}; ///< finite stand-ins for those at infinity; none for a ground
    /// Of a face that reaches from here to infinity: each corner's way from the eye, a direction for those at infinity. The
    /// stand-ins are too far for a tree of floats: it was several metres off at the near end.
    std::vector<Vec3d> ways{};
};

struct CastScene {
    std::vector<CastFace> faces;
    std::vector<std::int32_t> of_face; ///< parallel to VisualDatabase::faces: into `faces`, or none
    std::vector<std::int32_t> of_list; ///< parallel to VisualDatabase::lists: its ground in `faces`, or none
    std::vector<std::uint32_t> reaching; ///< into `faces`: those that have `ways`
};

/// Takes out of the database what a ray passes through: semi-opaque faces lose their area, additive lists their faces.
/// Levels of detail are replaced at once, without blend and hysteresis. What is left is what the machine and the caster must agree on.
VisualDatabase without_transparent(VisualDatabase database);

/// The faces that the packet has in the active data base, seen from `eye_m`.
CastScene cast_scene(const VisualDatabase& database, const FramePacket& packet, const Vec3d& eye_m);

} // namespace linkdig::tools
