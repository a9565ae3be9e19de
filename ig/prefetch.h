#pragma once
/// Asking for memory before it is needed; changes nothing but time.
///
/// Always inlined, as is whoever does nothing but call it: g++ 12 takes a function that only prefetches for one without any
/// effect, and drops its calls.

#define LINKDIG_ALWAYS_INLINE [[gnu::always_inline]] inline

namespace linkdig::ig {

/// The cache lines of a value, two of them at the most.
template <typename T>
LINKDIG_ALWAYS_INLINE void prefetch(const T* place) {
    __builtin_prefetch(place);
    if constexpr (sizeof(T) > 48) __builtin_prefetch(reinterpret_cast<const char*>(place) + sizeof(T) - 1);
}

} // namespace linkdig::ig
