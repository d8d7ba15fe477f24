#pragma once
// How many times as long one piece of work takes as another, on a machine that does other work too.

#include <functional>

#include "bench/core/measurement.h"

namespace glibra::bench {

struct PairedTiming {
    Timing first, second;  ///< seconds
    Timing ratio;          ///< first / second, of each pair: not seconds
};

/// Runs the two in turn, once to warm up and then `pairs` times, each long enough to be measured.
/// `byProcessor` counts the processor time of all threads of this process, which other processes disturb less
/// than the clock; it is right only for drivers that draw on the processor. The work must wait for the
/// device.
PairedTiming timePairs(const std::function<void()>& first, const std::function<void()>& second, int pairs,
                       bool byProcessor);

}  // namespace glibra::bench
