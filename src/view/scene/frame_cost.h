#pragma once
// What drawing a frame of the scene costs, the scene alone: no panels, no waiting for the screen.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "view/scene/session.h"

namespace glibra::view {

struct DrawCost {
    std::string word;  ///< the command
    int line = 0;
    int pass = 0;             ///< index into FrameCost::passes
    double milliseconds = 0;  ///< of the device, mean of all repeats
};

struct PassCost {
    std::string target;       ///< "window", "unit 6" or "units 6, 7"
    int line = 0;             ///< of the statement that begins it; 0: none does
    double milliseconds = 0;  ///< all its draws together
};

/// Counts of one frame by the driver's pipeline statistics.
struct PipelineCounts {
    std::uint64_t vertices = 0;    ///< vertex shader runs
    std::uint64_t primitives = 0;  ///< that reach the rasteriser, before clipping
    std::uint64_t fragments = 0;   ///< fragment shader runs
};

struct FrameCost {
    int frames = 0;
    double millisecondsAFrame = 0;  ///< real time, the device idle before and after
    std::vector<PassCost> passes;
    std::vector<DrawCost> draws;
    std::optional<PipelineCounts> counts;  ///< nothing if the driver has no such queries
};

/// Draws the present frame again and again, at least that many times and that many seconds.
FrameCost measureFrames(Session& session, const gpu::Capabilities& capabilities, int leastFrames,
                        double leastSeconds);

}  // namespace glibra::view
