#pragma once
// Measures what a frame of the scene costs: the scene alone, without panels and without waiting for the
// screen.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "view/session/session.h"

namespace glibra::view {

struct DrawCost {
    std::string word;  ///< the command
    int line = 0;
    int pass = 0;             ///< index into FrameCost::passes
    double milliseconds = 0;  ///< device time, mean of all repeats
};

struct PassCost {
    std::string target;       ///< "window", "unit 6" or "units 6, 7"
    int line = 0;             ///< of the statement that begins the pass; 0: no statement does
    double milliseconds = 0;  ///< sum over its draws
};

/// What the driver's pipeline statistics count in one frame.
struct PipelineCounts {
    std::uint64_t vertices = 0;    ///< vertex shader invocations
    std::uint64_t primitives = 0;  ///< primitives that enter clipping
    std::uint64_t fragments = 0;   ///< fragment shader invocations
};

struct FrameCost {
    int frames = 0;                   ///< measured; 0: there was no picture to draw
    double millisecondsPerFrame = 0;  ///< real time; the device is idle before and after
    std::vector<PassCost> passes;
    std::vector<DrawCost> draws;
    std::optional<PipelineCounts> counts;  ///< empty if the driver has no such queries
};

/// Draws the current frame repeatedly: at least `leastFrames` times and for at least `leastSeconds`.
FrameCost measureFrames(Session& session, const gpu::Capabilities& capabilities, int leastFrames,
                        double leastSeconds);

}  // namespace glibra::view
