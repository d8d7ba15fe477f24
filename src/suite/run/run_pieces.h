#pragma once
// How a run is cut into pieces for its workers.

#include <cstddef>
#include <functional>
#include <vector>

namespace glibra::suite {

/// Pieces of consecutive items of 0..count-1: long ones first, so that a worker can overlap drawing one shot
/// with judging another and reuse what it loaded, single ones last, so that all workers end together. One
/// worker gets as long ones as may be. `joins(i)`: item i may be in one piece with item i - 1.
std::vector<std::vector<std::size_t>> planPieces(std::size_t count, int workers,
                                                 const std::function<bool(std::size_t)>& joins);

}  // namespace glibra::suite
