#pragma once
/// Repeats a periodic tile of squares over the plane of its list, from under the eye to the horizon.
///
/// Squares stand in square rings around the eye: ring k has squares of side cell * 2^k and uses every 2^k-th
/// vertex of the pattern, or the pattern's own coarser table. Everything is anchored to the world: the eye only decides which squares are coarse.
/// Three things keep the picture from cracking, popping and sparkling:
///   - coarse squares at a ring's inner border carry the fine ring's mid-edge vertex: no T-junctions;
///   - towards its outer border a ring's normals turn into what the next coarser ring interpolates at the
///   same places,
///     so that squares change their size where both sizes show the same;
///   - contrast fades to the pattern's mean normal, (0, 0, sin a) for a random one, before a square is under three lines high.
/// Beyond the last ring four faces with vertices at infinity reach the horizon.

#include "host/packet/frame_packet.h"
#include "ig/active/face_block.h"
#include "ig/configuration.h"

namespace linkdig::ig {

/// Squares at least this many lines high show the pattern's full contrast, under `faded_lines` none (EST,
/// chosen by looking: linear in between).
inline constexpr double full_contrast_lines = 6.0;
inline constexpr double faded_lines = 3.0;

/// Makes the tile's faces in `active`'s pools and points `block` at them by index; settle_made_faces turns
/// the indices into spans once the pools no longer grow. The rings are centred on the first channel that is
/// on.
void make_tile_faces(const VisualDatabase& database, const RepeatedTile& tile, const FramePacket& packet,
                     const Configuration& configuration, ActiveDatabase& active, FaceBlock& block);

} // namespace linkdig::ig
