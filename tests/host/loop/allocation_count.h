#pragma once
/// How often memory was asked for in this test program.

#include <cstdint>

namespace linkdig::host {

/// Calls of operator new so far, of all threads.
std::uint64_t allocations();

} // namespace linkdig::host
