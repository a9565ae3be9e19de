#pragma once
/// Large pages for large arrays: nearly all of the time of opening a large database goes into touching fresh pages.

#include <cstddef>

namespace linkdig::database {

/// Asks the system to back this memory, which has not been written yet, with large pages where it has any. Small
/// arrays, and systems that know no such request, stay as they are.
void prefer_large_pages(const void* begin, std::size_t bytes);

} // namespace linkdig::database
