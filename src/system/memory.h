#pragma once
// Memory that several processes share, files in memory, and what a process may take.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "system/file.h"

namespace glibra::system {

/// Memory that a process shares with its copies (process.h). It is zero at first, and takes up space only
/// where it is written. Where a sandbox forbids sharing, or the system has no copies, it is plain memory of
/// that kind.
class SharedMemory {
  public:
    explicit SharedMemory(std::size_t size);
    SharedMemory(const SharedMemory&) = delete;
    SharedMemory& operator=(const SharedMemory&) = delete;
    ~SharedMemory();

    /// Empty if the system has not given it.
    [[nodiscard]] std::span<std::byte> bytes() const { return bytes_; }

  private:
    std::span<std::byte> bytes_;
};

/// A file that other code of this process opens by its path, and that is gone with the object: in memory
/// where the system has such files.
class MemoryFile {
  public:
    /// Where files in memory are refused, as to a confined process, it is one without a name on the disk of
    /// `near`, a path. Throws std::system_error if the system gives none.
    explicit MemoryFile(const std::filesystem::path& near);
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;
    ~MemoryFile();

    [[nodiscard]] const std::string& path() const { return path_; }
    /// Throws std::system_error.
    void write(std::span<const std::byte> bytes) const;
    /// All of the file, which was written from beginning to end. Throws std::system_error; EFBIG if it has
    /// reached the largest size that this process may write, which holds for files in memory, too: it has
    /// lost what comes after.
    [[nodiscard]] std::vector<unsigned char> content() const;

  private:
    File file_;
    std::string path_;
};

/// Limits the private memory that this process can write to, not the addresses: a driver reserves many times
/// the addresses that it uses. Beyond the limit, allocation fails as if the machine had no memory left.
class MemoryLimit {
  public:
    /// The memory that the process has now is not counted.
    MemoryLimit();
    /// Replaces the limit; 0: no limit. It outlives the object.
    void set(std::uint64_t bytes) const;
    /// The same, unless the process has a lower limit, which it keeps then.
    void lower(std::uint64_t bytes) const;
    /// Sets a limit that this process can never raise again, unless it has the rights of the superuser; 0: no
    /// limit.
    void setForever(std::uint64_t bytes) const;

  private:
    std::uint64_t base_;
};

/// While it lives, the process has no limit that it may raise again; what it takes meanwhile is not counted:
/// for code whose beginning must not fail, as that of libraries.
class LiftedMemoryLimit {
  public:
    LiftedMemoryLimit();
    LiftedMemoryLimit(const LiftedMemoryLimit&) = delete;
    LiftedMemoryLimit& operator=(const LiftedMemoryLimit&) = delete;
    ~LiftedMemoryLimit();

  private:
    std::uint64_t before_ = 0;  ///< the limit; 0: none
    std::uint64_t taken_ = 0;   ///< memory of the process
};

/// Ends this process when it has used that much processor time from its start on, in whole seconds, for good.
void limitProcessorTime(double seconds);
/// No file of its memory is left when this process crashes.
void leaveNoCore();
/// A write beyond the largest size of a file (ulimit -f) fails with EFBIG, and does not end this process.
void failBeyondLargestFile();
/// Ends this process after that time, unless it is called again; 0: not any more.
void endAfter(unsigned seconds);
/// Gives others the processor first.
void stepBack();

}  // namespace glibra::system
