#pragma once
// The memory that a process should be content with (system::MemoryLimit).

#include <cstddef>
#include <cstdint>

namespace glibra::base {

/// The memory that a worker may take if nothing else is said: half of the memory of the machine (or of the
/// control group, if that has less), divided by the number of workers, but at least kLeastShare. There are
/// `jobs` workers, or fewer if there are fewer pieces of work.
std::uint64_t memoryShare(int jobs, std::size_t pieces);
inline constexpr std::uint64_t kLeastShare = std::uint64_t{2} << 30;

}  // namespace glibra::base
