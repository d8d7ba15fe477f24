#pragma once
// Calls in processes of their own, and the memory that a process should be content with.

#include <cstddef>
#include <cstdint>
#include <functional>

namespace glibra::base {

// The memory that a process should be content with (system::MemoryLimit).

/// The memory that a worker may take if nothing else is said: half of the memory of the machine (or of the
/// control group, if that has less), divided by the number of workers, but at least kLeastShare. There are
/// `jobs` workers, or fewer if there are fewer pieces of work.
std::uint64_t memoryShare(int jobs, std::size_t pieces);
inline constexpr std::uint64_t kLeastShare = std::uint64_t{2} << 30;

// Runs one function in a process of its own, so that a function of foreign code that hangs, crashes or takes
// all memory affects nothing else.

/// What a contained call may take. A lower limit of memory of the calling process holds on.
struct CallLimits {
    double seconds = 20;                 ///< of time, and of processor time; 0: no limit
    std::uint64_t memory = kLeastShare;  ///< bytes beyond what the calling process has; 0: no limit
};

struct CallEnd {
    enum class Kind { finished, timedOut, died, notStarted };
    Kind kind = Kind::finished;
    int signal = 0;  ///< that ended the process, if it died; 0: it exited
};

/// Calls `work` in a copy of this process and waits for its end. Results come back through
/// system::SharedMemory; nothing else that `work` changes is seen by the caller. `work` must not throw. May
/// be called from any thread. Where the system copies no processes (Windows), `work` is done by this one,
/// without limits.
CallEnd runContained(const CallLimits& limits, const std::function<void()>& work);

/// Calls `work` in a thread of this process, for one that may not fork (a sandbox), and waits for its end.
/// Only the limit of time holds. False if the time is over: then `work` goes on until this process ends, so
/// it must own all that it uses.
bool runInThread(const CallLimits& limits, std::function<void()> work);

}  // namespace glibra::base
