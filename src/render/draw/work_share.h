#pragma once
// Work for a device that others use too is cut into parts, so that none of them takes long: a driver resets
// the device when a draw keeps it for seconds (gpu/context/reset.h).

#include <functional>

namespace glibra::render {

/// The seconds that one part of a draw may take on a device that is not the processor.
inline constexpr double kTimeShare = .1;

/// Does the rows 0 to `rows` - 1 of a draw, each once, in parts that take about `share` seconds. `timed` does
/// the rows from `first` to `end` - 1, waits for the device, and returns the seconds that this took; with
/// equal numbers it does what every part costs besides its rows. Returns the number of parts.
int doInShares(int rows, double share, const std::function<double(int first, int end)>& timed);

}  // namespace glibra::render
