#pragma once
// The processes of base::runInWorkers, each with a pipe for requests and one for answers. Where the system
// copies processes, a worker is a copy that goes on with `serve`. Where it does not, a worker is this program
// started again with its arguments, which comes to the same call of runInWorkers and serves there. On its way
// it has no standard streams, and the functions of this room that change files, locks and other programs do
// nothing and report success: its parent has done that.

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "system/process.h"

namespace glibra::system {

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
