#include "base/memory_limit.h"

#include <algorithm>

#include "system/places.h"

namespace glibra::base {

std::uint64_t memoryShare(int jobs, std::size_t pieces) {
    const auto workers = std::min<std::uint64_t>(static_cast<std::uint64_t>(std::max(1, jobs)), pieces);
    return std::max(kLeastShare, system::usableMemory() / 2 / std::max<std::uint64_t>(1, workers));
}

}  // namespace glibra::base
