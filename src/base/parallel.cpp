#include "base/parallel.h"

#include <algorithm>
#include <exception>
#include <mutex>
#include <new>
#include <system_error>
#include <thread>
#include <vector>

namespace glibra::base {

std::size_t threadCount(int wanted) {
    return wanted > 0 ? static_cast<std::size_t>(wanted) : std::max(1U, std::thread::hardware_concurrency());
}

void runOnThreads(std::size_t threads, const std::function<void()>& work) {
    std::mutex mutex;
    std::exception_ptr first;
    const auto run = [&] {
        try {
            work();
        } catch (...) {
            const std::scoped_lock lock(mutex);
            if (!first) first = std::current_exception();
        }
    };
    {
        std::vector<std::jthread> others;
        try {
            while (others.size() + 1 < threads) others.emplace_back(run);
        } catch (const std::system_error&) {
            // The machine has no more threads; those that run do all the work.
        } catch (const std::bad_alloc&) {
            // There is no memory for another thread; those that run do all the work.
        }
        run();
    }
    if (first) std::rethrow_exception(first);
}

}  // namespace glibra::base
