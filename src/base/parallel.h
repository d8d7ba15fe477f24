#pragma once
// One loop on several threads.

#include <atomic>
#include <cstddef>
#include <functional>

namespace glibra::base {

/// `wanted` threads; 0 or less: one per processor.
std::size_t threadCount(int wanted);

/// Calls work() once on the calling thread and once on each of up to `threads` - 1 others, and returns when
/// all calls have returned. If the machine gives fewer threads, fewer calls are made, but always at least
/// one. The first exception that leaves work() is thrown here, once all threads have ended.
void runOnThreads(std::size_t threads, const std::function<void()>& work);

/// Calls work(index, state) once for each index below `count`, in any order, on up to `threads` threads (0:
/// one per processor). Each thread uses a `state` of its own, made by makeState() on that thread. After an
/// exception no further index begins; the first one is thrown here.
template <class MakeState, class Work>
void forEachIndex(std::size_t count, int threads, const MakeState& makeState, const Work& work) {
    if (count == 0) return;
    const std::size_t wanted = threadCount(threads);
    std::atomic<std::size_t> next{0};
    runOnThreads(wanted < count ? wanted : count, [&] {
        try {
            auto state = makeState();
            for (std::size_t index = next++; index < count; index = next++) work(index, state);
        } catch (...) {
            next = count;
            throw;
        }
    });
}

/// The same without a state: calls work(index).
template <class Work>
void forEachIndex(std::size_t count, int threads, const Work& work) {
    struct Nothing {};
    forEachIndex(count, threads, [] { return Nothing{}; }, [&](std::size_t index, Nothing) { work(index); });
}

}  // namespace glibra::base
