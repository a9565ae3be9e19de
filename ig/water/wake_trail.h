#pragma once
/// A ship's wake as a function of her history, what LINK's report wished for (2.0): her last minutes of track become faces each frame.
///
/// Every wave that she made runs on from where it left her, at its group speed: from the place P where she was an age a ago, at an
/// angle u off her course of then, (U a / 2) cos u metres. On a straight track that is Kelvin's pattern, a cone of 19.47 degrees; and
/// it goes on being what it was when she turns, changes her speed or stops. The waves of (P, u) stand at the phase g a / (2 U cos u):
/// what a ship makes that moves steadily has no frequency of its own, and half of what a wave's crests run ahead of its group is
/// what they lose against it.
///
/// The mesh's rows are lines of one phase on a straight track: of the ages T cos u, T a multiple of the row's step. So the rows lie
/// along the crests, few faces hold many waves, and nothing in it ever jumps: each vertex is a continuous function of time.

#include "host/packet/frame_packet.h"
#include "ig/active/face_block.h"
#include "ig/active/wake_history.h"

namespace linkdig::ig {

inline constexpr double track_interval_s = 0.5; ///< between two samples

/// Where a ship of this request is in this packet.
TrackSample track_sample(const WakeRequest& wake, const FramePacket& packet);

/// Brings the track up to the packet. It begins anew, as if she had come straight on at her speed, where there is none yet, where the
/// packet says that the scene jumped, and where time went back or a gap is longer than the wake's age.
void follow_track(const WakeRequest& wake, const FramePacket& packet, WakeTrail& trail);

/// Where she was so long before `now`: between samples on a cubic that keeps her velocity, before the first where that was.
TrackSample track_at(const WakeTrail& trail, const TrackSample& now, double age_s);

/// A vertex of the wake.
struct WakePoint {
    Vec2d position_m{0.0};
    double height_m = 0.0;
    Vec2d slope{0.0};
    double light = 0.0; ///< of foam, straight up; 0 to 1
};

/// A row of the mesh. Its edges are where neighbouring waves touch: 35.26 degrees off on a straight track, acos(sqrt(2/3)), elsewhere
/// as the track bends, less on the outside of a turn and more on the inside. Between them lie the transverse waves, beyond them the
/// diverging ones, and neither mesh folds over.
struct WakeRow {
    double row_s = 0.0;    ///< T
    double step_s = 0.0;   ///< to the next
    double low_rad = 0.0;  ///< angle of the waves at the port edge, negative
    double high_rad = 0.0; ///< and at the starboard edge
    double low_part =
        1.0; ///< of the waves along the port edge: less where rows crowd, on the inside of a turn
    double high_part = 1.0;
};
WakeRow wake_row(const WakeRequest& wake, const WakeTrail& trail, const TrackSample& now, double row_s,
                 double step_s);

/// The wave of a row that left at an angle u, radians, positive to starboard.
WakePoint wave_point(const WakeRequest& wake, const WakeTrail& trail, const TrackSample& now,
                     const WakeRow& row, double u_rad);

/// Where light has ended beyond the starboard (`side` 1) or port edge (-1).
WakePoint fringe_point(const WakeRequest& wake, const WakeTrail& trail, const TrackSample& now,
                       const WakeRow& row, double side);

/// Churned water that her stern left T seconds ago, `across` -1 (starboard edge) to 1 (port edge).
WakePoint foam_point(const WakeRequest& wake, const WakeTrail& trail, const TrackSample& now, double row_s,
                     double across);

/// Rows of faces that the request's reserve allows.
std::uint32_t trail_rows(const WakeRequest& wake);

/// Makes the faces that are not dark, in the pools of `active`, for a block that stands in the world. At most
/// `wake.most_faces`. `rows` is memory, kept from frame to frame.
void make_trail_faces(const WakeRequest& wake, const WakeTrail& trail, const TrackSample& now,
                      std::vector<WakeRow>& rows, ActiveDatabase& active, FaceBlock& block);

} // namespace linkdig::ig
