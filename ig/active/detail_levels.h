#pragma once
/// Levels of detail: which are present this frame, and how much of them is seen.
///
/// The range is that of the nearest eye of all channels that are on from the detail's reference point. One range for all
/// channels: windows of a cab that meet at a mullion show one level. The packet's bias b acts as if that range were
/// 2^-b of what it is: with +1 every level reaches twice as far.

#include "host/packet/frame_packet.h"
#include "ig/active/face_block.h"
#include "ig/active/history.h"

#include <span>

namespace linkdig::ig {

/// How much of a level is seen, of 256: 0 is absent, 256 wholly present.
inline constexpr std::uint16_t whole_level = 256;

/// Fills `active.level_opacity` and `detail_range_m` from the clusters' poses, and brings `history.held_level` up to this
/// frame. Without an eye every detail keeps to what it held.
void choose_levels(const VisualDatabase& database, const FramePacket& packet, History& history,
                   ActiveDatabase& active);

/// A range under a bias b: 2^-b of it, exact where there is no bias.
double biased_range_m(double range_m, double bias);

/// Opacities of a detail's levels at a (biased) range, given the level held.
void level_opacities(const VisualDatabase& database, const Detail& detail, double range_m, std::uint32_t held,
                     std::span<std::uint16_t> opacities);

/// The level whose range it is, given the one held (`levels` or more: none held): it is left where the range is more than
/// half the hysteresis beyond its ends. Returns `levels` beyond the last.
std::uint32_t level_at(const VisualDatabase& database, const Detail& detail, double range_m,
                       std::uint32_t held);

/// Opacity of level `k` of a detail that blends, of 256. In the first half of each blend the coarser level appears behind
/// the finer one, in the second the finer one vanishes before the coarser: one of the two is always whole, so nothing
/// shines through, and all changes are gradual whichever of them lies in front.
std::uint16_t blended_opacity(const VisualDatabase& database, const Detail& detail, double range_m,
                              std::uint32_t k);

} // namespace linkdig::ig
