#include "database/format/large_pages.h"

#include <sys/mman.h>

#include <cstdint>

namespace linkdig::database {

void prefer_large_pages([[maybe_unused]] const void* begin, [[maybe_unused]] std::size_t bytes) {
#ifdef MADV_HUGEPAGE
    constexpr std::uintptr_t page = std::uintptr_t{2} << 20U; // of x86-64
    const auto first = (reinterpret_cast<std::uintptr_t>(begin) + page - 1) / page * page;
    const auto end = (reinterpret_cast<std::uintptr_t>(begin) + bytes) / page * page;
    // A refusal is no error: the memory is there all the same.
    // NOLINTNEXTLINE(performance-no-int-to-ptr): the address was rounded up to a page
    if (first < end) (void)madvise(reinterpret_cast<void*>(first), end - first, MADV_HUGEPAGE);
#endif
}

} // namespace linkdig::database
