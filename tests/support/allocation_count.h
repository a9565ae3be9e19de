#pragma once
/// How often memory was asked for in this test program.

#include <cstdint>

namespace linkdig {

/// Allocations so far, of all threads: calls of operator new; under the thread sanitizer of malloc too.
std::uint64_t allocations();

} // namespace linkdig
