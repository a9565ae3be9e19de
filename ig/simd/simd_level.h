#pragma once
/// Which vectors the machine uses: chosen by what the processor has, or by name, for tests. No picture depends on it.

#include <string>
#include <vector>

namespace linkdig::ig {

/// SIMD levels of this build that the machine has, best first; the last is always "scalar".
std::vector<std::string> simd_levels();

/// SIMD levels of this build that the machine lacks.
std::vector<std::string> missing_simd_levels();

/// Uses this level from now on ("" or "best": the best there is). False if the machine lacks it; then nothing
/// changes. Not while a frame is drawn.
bool use_simd_level(const std::string& level);

/// "scalar" is in use.
bool simd_is_off();

} // namespace linkdig::ig
