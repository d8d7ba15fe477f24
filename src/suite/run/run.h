#pragma once
// Draws the shots of suites in worker processes and judges them there, so that pictures never travel through
// a pipe. A shot that crashes, hangs or runs out of memory affects only itself.

#include <functional>
#include <span>
#include <string>

#include "suite/results/results.h"
#include "suite/run/run_options.h"
#include "suite/suite.h"

namespace glibra::suite {

struct RunEvents {
    /// Called for each shot as it is done, in any order.
    std::function<void(const ShotResult&)> done;
    /// Called before a worker draws a shot.
    std::function<void(const ShotReference&)> begins;
    /// Called regularly. Once it returns true, the run ends with the shots that are done.
    std::function<bool()> stop;
};

struct RunEnd {
    std::string driver;       ///< GL_RENDERER and GL_VERSION; empty if no shot was drawn
    Diagnostics diagnostics;  ///< of the run: hash lists, no driver (gpu-E01)
    bool noDriver = false;
    bool stopped = false;
};

/// Call it before any thread or GL context exists.
RunEnd runShots(std::span<const Suite> suites, std::span<const ShotReference> shots,
                const RunOptions& options, const RunEvents& events);

}  // namespace glibra::suite
