#pragma once
/// The shedding order: what a machine with limits leaves out, step by step, while it has too much to draw.
///
///   steps 1 to 8    levels of detail end at 2^(-step/2) of their range, down to 1/16: coarser levels take their place
///   steps 9 to 16   besides, objects that look smaller than 2^(step-9) pixels are left out: 1 to 128
///
/// Light points have a limit and steps of their own (ig/active/light_steps.h), since nothing else that is left out makes
/// them fewer.
///
/// Which step a frame is drawn at was decided by counts of the frames before it (ig/machine/load.h), never by time. The
/// step is one for all channels: what one window of a cab leaves out, its neighbour does.

#include "host/packet/frame_packet.h"
#include "ig/active/face_block.h"
#include "ig/configuration.h"

#include <cstdint>
#include <vector>

namespace linkdig::ig {

inline constexpr std::uint32_t level_steps = 8;
inline constexpr std::uint32_t size_steps = 8;
inline constexpr std::uint32_t most_steps = level_steps + size_steps;

/// Added to the packet's bias of levels: 0 to -4.
inline double bias_at_step(std::uint32_t step) { return -0.5 * (step < level_steps ? step : level_steps); }

/// Objects that look smaller than this are left out; 0: none.
inline double least_size_px(std::uint32_t step) {
    return step <= level_steps ? 0.0 : static_cast<double>(1U << (step - level_steps - 1));
}

/// Bounding spheres and edges of all objects; once in a machine's life.
std::vector<ObjectWorth> object_worths(const VisualDatabase& database);

/// Fills `active.object_px` from the blocks, and `active.object_shed` for the step.
void shed_objects(const VisualDatabase& database, const FramePacket& packet, const Raster& raster,
                  std::uint32_t step, ActiveDatabase& active);

} // namespace linkdig::ig
