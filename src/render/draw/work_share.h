#pragma once
// Work for a device that others use too is cut into parts, so that none of them takes long: a driver resets
// the device when a draw keeps it for seconds (gpu/context/driver_reports.h).

#include <functional>

namespace glibra::render {

/// The seconds that one part of a draw may take on a device that is not the processor.
inline constexpr double kTimeShare = .1;
/// Work that takes less than this part of the share is not waited for.
inline constexpr double kQuickShare = .25;

/// How work was done in parts.
struct Shares {
    int parts = 1;
    double seconds = 0;  ///< at most, that all took
};

/// Does the rows 0 to `rows` - 1 of a draw, each once, in parts that take about `share` seconds. `work` hands
/// the rows from `first` to `end` - 1 to the device; with equal numbers, what every part costs besides its
/// rows. `wait` waits for the device and returns the seconds since it returned last. The device idles
/// meanwhile, so the last rows of work that is quick are not waited for.
Shares doInShares(int rows, double share, const std::function<void(int first, int end)>& work,
                  const std::function<double()>& wait);

}  // namespace glibra::render
