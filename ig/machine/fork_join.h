#pragma once
/// The one fork and join of a frame: pieces of work shared among the threads of an arena.
///
/// TBB's library is not built with the thread sanitizer, which would see none of its synchronisation and take every hand-over
/// for a race. Under the sanitizer plain threads do the same work instead, and races in the pieces are told.

#if defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define LINKDIG_THREAD_SANITIZER 1
#endif
#endif

#ifdef LINKDIG_THREAD_SANITIZER
#include <atomic>
#include <thread>
#include <vector>
#else
#include <tbb/parallel_for.h>
#endif

#include <tbb/task_arena.h>

#include <cstdint>

namespace linkdig::ig {

/// Calls work(piece, thread) once for each piece in [0, pieces), thread < the arena's size. What was done before is seen by
/// all pieces, and what they do by whatever comes after; pieces see nothing of each other, unless they run on the same thread.
template <typename Work>
void fork_join(tbb::task_arena& arena, std::uint32_t pieces, const Work& work) {
#ifdef LINKDIG_THREAD_SANITIZER
    std::atomic<std::uint32_t> next{0};
    std::vector<std::thread> threads;
    for (std::uint32_t thread = 0; thread < static_cast<std::uint32_t>(arena.max_concurrency()); ++thread)
        threads.emplace_back([&next, &work, pieces, thread] {
            for (std::uint32_t piece = next++; piece < pieces; piece = next++)
                work(piece, thread);
        });
    for (std::thread& thread : threads)
        thread.join();
#else
    arena.execute([&] {
        tbb::parallel_for(0U, pieces, [&](std::uint32_t piece) {
            work(piece, static_cast<std::uint32_t>(tbb::this_task_arena::current_thread_index()));
        });
    });
#endif
}

} // namespace linkdig::ig
