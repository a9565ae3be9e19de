#pragma once
/// References that failed become what was drawn.

#include "tools/compare/compare.h"

#include <cstdint>
#include <string>

namespace linkdig::compare {

/// Rewrites the expected file of a frame that differs, has another shape, is extra, or whose reference alone
/// cannot be read, from the actual picture: a whole file in the place of the other. Whatever else is left as it is.
/// True if a file was written. Throws std::runtime_error, naming the file, if it cannot be written.
bool update_reference(const FrameResult& frame, const std::string& expected_folder);

} // namespace linkdig::compare
