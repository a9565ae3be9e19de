#pragma once
/// Pictures as committed hashes, at every thread count and SIMD level.

#include "host/packet/frame_packet.h"
#include "ig/configuration.h"

#include <span>
#include <string>
#include <vector>

namespace linkdig::determinism {

struct NamedPacket {
    std::string name; ///< of the hash, without blanks
    FramePacket packet;
};

/// Draws channel 0 of each packet with 1, 2 and 4 threads at every SIMD level that the processor has. Expects one
/// and the same hash of all of them, and that it is the committed one. Prints a table: compiler, build type,
/// threads, SIMD level, hash; a level of the build that the processor lacks is named as not checked.
void expect_pictures(const VisualDatabase& database, std::span<const NamedPacket> packets,
                     const ig::Raster& raster, bool edge_smoothing = false);

} // namespace linkdig::determinism
