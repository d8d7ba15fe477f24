#pragma once
// How pieces of work in other processes end.

#include <string>

#include "base/device_lost.h"

namespace glibra::base {

/// How one piece of work ended.
struct Outcome {
    enum class End { finished, timedOut, crashed, stopped, deviceLost };
    End end = End::finished;
    std::string answer{};  ///< what the work returned, if it finished
    int signal = 0;        ///< that ended the process, if it crashed; 0: it exited
    int process = 0;       ///< the process id, if it did not finish
    /// The process crashed and had used more than half of the memory that it may have: an allocation that
    /// failed is a likely cause.
    bool nearMemoryLimit = false;
    DeviceLost lost{};      ///< if the graphics device was reset
    bool wasAlone = false;  ///< no other piece was being done meanwhile
};

}  // namespace glibra::base
