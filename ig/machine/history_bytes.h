#pragma once
/// The machine's history as bytes: the first record of a recording (host/packet/recording.h), which holds it without
/// knowing what it is.
///
/// All numbers little-endian, 32 bits each: version; number of details; the level held of each; load: step, calm, over,
/// light step, light calm. Version 1 had no light steps; it is still read. A history with wakes is written as version 3,
/// one without as version 2. Version 3 goes on with the number of trails, each its list, its number of samples and their
/// values; and with the number of particles' wakes, each its list, whether it has begun, its own values, its number of
/// particles and theirs. Values are doubles, the lower half first.

#include "ig/active/history.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace linkdig::ig {

std::vector<std::uint8_t> encode_history(const History& history);

/// No bytes are the history of a machine that has drawn nothing. Nothing if the bytes are no history of this version.
std::optional<History> decode_history(std::span<const std::uint8_t> bytes);

} // namespace linkdig::ig
