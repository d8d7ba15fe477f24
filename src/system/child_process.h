#pragma once
// This program started again as a helper of its window: a channel of bytes in both directions, and memory
// that both share and either may change in size.

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "system/process.h"

namespace glibra::system {

/// Wakes a thread that waits in receive().
class Waker {
  public:
    Waker();
    /// May be called from any thread, and from a handler of signals. False if it cannot.
    bool wake() const;
    /// Waits for wake().
    void wait() const;
    [[nodiscard]] const File& file() const { return reading_; }
    explicit operator bool() const { return static_cast<bool>(reading_); }

  private:
    File reading_, writing_;  ///< the second one only where it is another one
};

enum class News { bytes, ended, late, woken };
/// Appends to `received` what comes through a pipe or a channel within the time (-1: no limit). `late`:
/// nothing came; `woken`: wake() was called, whatever else has come.
News receive(const File& from, int milliseconds, const Waker* waker, std::string& received);

/// Memory of several processes.
class SharedFile {
  public:
    SharedFile() = default;
    explicit SharedFile(File file) : file_(std::move(file)) {}
    SharedFile(SharedFile&& other) noexcept;
    SharedFile& operator=(SharedFile&& other) noexcept;
    ~SharedFile() { unmap(); }
    /// New memory without a size. False if the system gives none.
    bool make();
    /// Gives it a size, for all processes, and maps it here. False if there is not so much memory.
    bool resize(std::size_t size);
    /// Maps what another process has given a size. False if that fails.
    bool map(std::size_t size);
    void unmap();
    [[nodiscard]] std::span<std::byte> bytes() const { return bytes_; }
    [[nodiscard]] const File& file() const { return file_; }

  private:
    File file_;
    std::span<std::byte> bytes_;
};

/// The parent's view of a helper.
struct ChildProcess {
    Process process{};
    File channel{};
    SharedFile memory{};
};
/// Starts this program with these words. What it prints as errors is discarded. Nothing if that fails.
std::optional<ChildProcess> startChild(const std::vector<std::string>& words);
/// Ends it at once, and waits for it.
void end(ChildProcess& child);

/// The ends that this process got from startChild(). It is ended with its parent, and no file of its memory
/// is left when it crashes.
struct ParentEnds {
    File channel;
    SharedFile memory;
};
ParentEnds endsOfThisChild();

}  // namespace glibra::system
