#pragma once
// Measures what a frame of the scene costs: the scene alone, without panels and without waiting for the
// screen.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "view/session/session.h"

namespace glibra::view {

struct DrawCost {
    std::string word;  ///< the command
    int line = 0;
    std::size_t node = 0;     ///< index into FrameCost::nodes
    double milliseconds = 0;  ///< GPU time (gpu/object/timer.h), mean of all repeats
    scene::StepIndex step{};
};

/// A pass, dispatch or clear.
struct NodeCost {
    std::string what;         ///< "pass into window", "dispatch of Move", "clear of hits"
    int line = 0;             ///< of its statement; 0: no statement begins the pass
    double milliseconds = 0;  ///< GPU time with all that belongs to it, mean of all repeats
};

/// A Once or Step block.
struct BlockCost {
    std::string what;  ///< "Once", "Step 60"
    int line = 0;
    int runs = 0;                 ///< that were measured: the last ones before the time of the picture
    double milliseconds = 0;      ///< GPU time of one run
    std::vector<NodeCost> nodes;  ///< in one run
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
    bool isTimed =
        false;  ///< false: the driver has no timer, and this process waits for the device at each part
    /// The times of the parts are estimates: without a timer, or because the processor draws, which would do
    /// parts together that are measured one by one.
    bool isEstimate = false;
    /// GPU time of a frame whose parts are measured, in the same frames as these: no part is longer.
    double millisecondsOfParts = 0;
    std::vector<NodeCost> nodes;  ///< of the frame, in order
    std::vector<DrawCost> draws;
    std::vector<BlockCost> blocks;
    std::optional<PipelineCounts> counts;  ///< empty if the driver has no such queries
};

/// Decimals that a time has in the list: three, and for estimates as many as give the whole frame two digits.
int decimalsOf(const FrameCost& cost);
/// A time with that many decimals, cut off, so that parts do not exceed their whole: "1.2", "< 0.1".
std::string millisecondsText(double milliseconds, int decimals);

/// Measures the times of the parts of the current frame alone, in a few frames: isTimed, isEstimate,
/// millisecondsOfParts, nodes, draws.
FrameCost measureParts(Session& session, const gpu::Capabilities& capabilities);

/// Draws the current frame repeatedly: at least `leastFrames` times and for at least `leastSeconds`. Steps
/// are run again from the start, and the last ones are measured.
FrameCost measureFrames(Session& session, const gpu::Capabilities& capabilities, int leastFrames,
                        double leastSeconds);

// Decides when the next frame of a moving scene is due. A driver that waits for the screen sets the pace
// itself; without one, this keeps a scene from being drawn more often than the screen shows it.

class FramePacer {
  public:
    /// `framesPerSecond`: the screen's refresh rate, more than 0. `driverWaits`: presenting may wait for the
    /// screen.
    FramePacer(double framesPerSecond, bool driverWaits) : driverWaits_(driverWaits) {
        setRate(framesPerSecond);
    }

    /// A driver that waits does the last tenth of the waiting: a screen rarely has exactly the rate that it
    /// reports, and a slightly faster screen would otherwise miss a frame now and then.
    void setRate(double framesPerSecond) { period_ = (driverWaits_ ? kPart : 1) / framesPerSecond; }
    /// A frame begins at `now`, in seconds of any steady clock.
    void begin(double now) { begun_ = now; }
    /// Seconds from `now` until the next frame is due; 0 if it is overdue.
    [[nodiscard]] double secondsToNext(double now) const { return std::max(0.0, begun_ + period_ - now); }

  private:
    static constexpr double kPart = .9;
    bool driverWaits_ = false;
    double period_ = 0;
    double begun_ = 0;
};

}  // namespace glibra::view
