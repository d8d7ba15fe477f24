#pragma once
// Limits on the memory of a process.

#include <cstddef>
#include <cstdint>

namespace glibra::base {

/// The memory that a worker may take if nothing else is said: half of the memory of the machine (or of the
/// control group, if that has less), divided by the number of workers, but at least kLeastShare. There are
/// `jobs` workers, or fewer if there are fewer pieces of work.
std::uint64_t memoryShare(int jobs, std::size_t pieces);
inline constexpr std::uint64_t kLeastShare = std::uint64_t{2} << 30;

/// Limits the private memory that this process can write to. This is RLIMIT_DATA, not the address space: a
/// driver reserves many times the addresses that it uses. Beyond the limit, allocation fails as if the
/// machine had no memory left.
class MemoryLimit {
  public:
    /// The memory that the process has now is not counted.
    MemoryLimit();
    /// Replaces the limit; 0: no limit. It outlives the object.
    void set(std::uint64_t bytes) const;
    /// Sets a limit that this process can never raise again, unless it has the rights of the superuser; 0: no
    /// limit.
    void setForever(std::uint64_t bytes) const;

  private:
    std::uint64_t base_;
};

}  // namespace glibra::base
