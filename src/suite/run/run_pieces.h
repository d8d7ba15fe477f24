#pragma once
// Divides a run into pieces for its workers.

#include <cstddef>
#include <functional>
#include <vector>

namespace glibra::suite {

/// Returns pieces of consecutive items of 0..count-1. Long pieces are first, so that a worker can overlap
/// drawing one shot with judging another and reuse what it loaded. Single items are last, so that all workers
/// end together. One worker gets pieces as long as possible. `joins(i)`: item i may be in the same piece as
/// item i - 1.
std::vector<std::vector<std::size_t>> planPieces(std::size_t count, int workers,
                                                 const std::function<bool(std::size_t)>& joins);

}  // namespace glibra::suite
