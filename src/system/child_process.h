#pragma once
// Processes of this program that work for it: children that it talks to, and workers.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "system/process.h"

namespace glibra::system {

// This program started again as a helper of its window: a channel of bytes in both directions, and memory
// that both share and either may change in size.

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

// The processes of base::runInWorkers, each with a pipe for requests and one for answers. Where the system
// copies processes, a worker is a copy that goes on with `serve`. Where it does not, a worker is this program
// started again with its arguments, which comes to the same call of runInWorkers and serves there. On its way
// it has no standard streams, and the functions of this room that change files, locks and other programs do
// nothing and report success: its parent has done that.

/// What a worker serves.
struct WorkerEnds {
    File requests{};           ///< it reads
    File answers{};            ///< it writes
    std::uint64_t memory = 0;  ///< bytes that it may take for good, as it was started
    std::uint64_t call = 0;    ///< the call that it serves: the number that startWorker() was given
};
/// Does not return.
using Serve = std::function<void(const WorkerEnds& ends)>;

/// A running worker, as its parent sees it. An object without a process is empty.
struct Worker {
    Process process{};
    File requests{};  ///< we write
    File answers{};   ///< we read
};

bool workersAreCopies();
/// The ends of this process, if it was started to be a worker. Only where workers are no copies; asked once.
std::optional<WorkerEnds> endsOfThisWorker();

/// In a worker, before its first piece: it ends with its parent, is the first to end when memory runs out,
/// leaves Ctrl+C and the like to its parent, and from now on prints errors and changes files.
void becomeWorker();
/// Writes out what the worker has printed and ends it, without the destructors of its parent's objects.
[[noreturn]] void endWorker(int status);

/// Starts a worker. None of the pipes of `others` stays open in it: they would hide from the parent that a
/// worker died. Nothing if the system has no process or no pipe left.
/// `serve`: of a copy; `call`: of another process.
std::optional<Worker> startWorker(std::span<Worker* const> others, std::uint64_t memory, std::uint64_t call,
                                  const Serve& serve);

/// Waits until one of the workers has sent something or ended, at most that long; -1: for ever. `ready` tells
/// for each whether that is so. False if the wait was interrupted.
bool waitForAny(std::span<Worker* const> workers, int milliseconds, std::span<bool> ready);
enum class Received { some, interrupted, ended };
/// Appends what a worker has sent. It never waits if waitForAny says that there is something.
Received receive(const Worker& worker, std::string& to);
/// A worker that dies meanwhile is detected when its answers are read.
void send(const Worker& worker, std::span<const std::byte> bytes);
/// Closes the pipes, at whose end a worker ends by itself, and waits. The object is empty then.
End end(Worker& worker);

/// While it lives, writing to a pipe that nobody reads is an error that the writer reports.
class BrokenPipesAreErrors {
  public:
    BrokenPipesAreErrors();
    BrokenPipesAreErrors(const BrokenPipesAreErrors&) = delete;
    BrokenPipesAreErrors& operator=(const BrokenPipesAreErrors&) = delete;
    ~BrokenPipesAreErrors();

  private:
    struct State;
    std::unique_ptr<State> before_;
};

}  // namespace glibra::system
