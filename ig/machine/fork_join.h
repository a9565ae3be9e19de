#pragma once
/// Tells the thread sanitizer how the bands' threads are forked and joined: TBB is not built with it, so it would see none of
/// TBB's own synchronisation and take every hand-over for a race. Without the sanitizer nothing is left of it.

#if defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define LINKDIG_THREAD_SANITIZER 1
#endif
#endif

#ifdef LINKDIG_THREAD_SANITIZER
extern "C" void __tsan_acquire(void* address);
extern "C" void __tsan_release(void* address);
#endif

namespace linkdig::ig {

/// What was done before release(p) is seen after acquire(p).
inline void release([[maybe_unused]] void* place) {
#ifdef LINKDIG_THREAD_SANITIZER
    __tsan_release(place);
#endif
}
inline void acquire([[maybe_unused]] void* place) {
#ifdef LINKDIG_THREAD_SANITIZER
    __tsan_acquire(place);
#endif
}

/// One parallel loop: the bodies see what came before it, and what comes after sees them; bodies see nothing of each other,
/// unless they run on the same worker.
struct ForkJoin {
    char fork = 0;
    char join = 0;
    void begin() { release(&fork); }
    void enter(void* worker) {
        acquire(&fork);
        acquire(worker);
    }
    void leave(void* worker) {
        release(worker);
        release(&join);
    }
    void end() { acquire(&join); }
};

} // namespace linkdig::ig
