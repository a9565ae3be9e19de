#include "database/format/large_pages.h"

#include <sys/mman.h>

#include <algorithm>
#include <cstdint>
#include <new>

namespace linkdig::database {

namespace {

constexpr std::uintptr_t large = std::uintptr_t{2} << 20U; // of x86-64
constexpr std::uintptr_t small = 4096;

/// Asks for [begin, end); a refusal is no error: the memory is there all the same.
void advise([[maybe_unused]] std::uintptr_t begin, [[maybe_unused]] std::uintptr_t end,
            [[maybe_unused]] int what) {
    // NOLINTNEXTLINE(performance-no-int-to-ptr): the address was rounded to a page
    if (begin < end) (void)madvise(reinterpret_cast<void*>(begin), end - begin, what);
}

std::size_t in_large_pages(std::size_t count) { return (count + large - 1) / large * large; }

} // namespace

void FreeLargeBytes::operator()(std::uint8_t* bytes) const {
    ::operator delete (bytes, std::align_val_t{large});
}

LargeBytes large_bytes(std::size_t count) {
    const std::size_t whole = in_large_pages(count);
    LargeBytes bytes(static_cast<std::uint8_t*>(::operator new (whole, std::align_val_t{large})));
    prefer_large_pages(bytes.get(), whole);
    return bytes;
}

void prefer_large_pages([[maybe_unused]] const void* begin, [[maybe_unused]] std::size_t bytes) {
    if (bytes < large) return;
    const auto first = reinterpret_cast<std::uintptr_t>(begin);
    const auto end = first + bytes;
    const std::uintptr_t first_large = (first + large - 1) / large * large;
    const std::uintptr_t end_large = end / large * large;
#ifdef MADV_HUGEPAGE
    advise(first_large, end_large, MADV_HUGEPAGE);
#endif
#ifdef MADV_POPULATE_WRITE
    advise(first / small * small, std::min(first_large, end), MADV_POPULATE_WRITE);
    advise(std::max(end_large, first), end, MADV_POPULATE_WRITE);
#endif
}

} // namespace linkdig::database
