#pragma once
// Runs one function in a process of its own, so that a function of foreign code that hangs, crashes or takes
// all memory affects nothing else.

#include <cstdint>
#include <functional>

#include "base/memory_limit.h"

namespace glibra::base {

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
