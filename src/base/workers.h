#pragma once
// Work that many processes do, piece by piece.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <source_location>
#include <string>
#include <string_view>
#include <vector>

#include "base/device_lost.h"
#include "system/file.h"
#include "system/sandbox.h"

namespace glibra::base {

// How pieces of work in other processes end.

/// How one piece of work ended.
struct Outcome {
    enum class End { finished, timedOut, crashed, stopped, deviceLost };
    End end = End::finished;
    std::string answer{};  ///< what the work returned, if it finished
    int signal = 0;        ///< that ended the process, if it crashed; 0: it exited
    int process = 0;       ///< the process id, if it did not finish
    /// The process crashed and had used more than half of the memory that it may have: an allocation that
    /// failed is a likely cause.
    bool nearMemoryLimit = false;
    DeviceLost lost{};      ///< if the graphics device was reset
    bool wasAlone = false;  ///< no other piece was being done meanwhile
};

// Where a worker is this program started again, it passes the calls of runInWorkers that its parent has made
// before. They do no work there: their callers hear once more what the parent's have heard, so that both come
// to the same state.

/// What a call has told its caller.
struct WorkerEvent {
    enum class Kind : std::uint32_t { progress, repeated, done };
    Kind kind = Kind::progress;
    std::size_t index = 0;
    Outcome outcome{};   ///< not of `progress`
    std::string text{};  ///< of `progress`
};

/// The calls of a process by their numbers.
using WorkerCalls = std::map<std::uint64_t, std::vector<WorkerEvent>>;

/// A call is known by its place in the source and by how often that place was passed before, not by how many
/// calls were made: some are made only if a file exists, which other workers may have made meanwhile.
std::uint64_t numberOfCall(std::string_view place, std::size_t times);

/// The calls as bytes, with their length first.
std::string toBytes(const WorkerCalls& calls);
/// Reads what toBytes() wrote; no calls if the pipe has something else.
WorkerCalls receiveCalls(const system::File& pipe);

// Runs work in separate processes, so that a piece that crashes the driver, hangs or runs out of memory
// affects only itself.

/// True if the end of a piece may be the fault of another one, or of another program: the device was reset,
/// and not for its sake, or (`sharesDevice`) it was late because another one held the device. It is then done
/// again, while no other piece is. `times` is how often that has been done already.
bool mayBeInnocent(const Outcome& outcome, bool sharesDevice, int times);

struct WorkerOptions {
    int workers = 1;           ///< number of processes, at least 1
    double timeout = 0;        ///< seconds that one step of a piece may take; 0: no limit
    std::uint64_t memory = 0;  ///< bytes that a worker may take (system/memory.h); 0: no limit
    /// The time limit and the memory of one piece, if the pieces have different limits.
    std::function<double(std::size_t index)> timeoutOf{};
    std::function<std::uint64_t(std::size_t index)> memoryOf{};
    /// If given, it is asked for the seconds that a piece has left, when the piece begins and after each of
    /// its steps, instead of the time limits above; 0: no limit.
    std::function<double(std::size_t index)> timeLeft{};
    /// Called five times a second. After it returns true, no further piece begins and the running ones are
    /// ended.
    std::function<bool()> stop{};
    /// The workers draw with one graphics device. When it has been reset, the time limits of the other pieces
    /// begin anew, because the device was held meanwhile.
    bool sharesDevice = false;
    /// Pieces that may be innocent of their end (mayBeInnocent) are done again when all others are done, each
    /// alone. If false, `done` gets their outcomes.
    bool repeats = true;
    /// Called before a piece is done again, with the outcome that does not count.
    std::function<void(std::size_t index, const Outcome&)> repeated{};
    /// If given, every worker enters this sandbox before its first piece; one that cannot ends by itself. One
    /// that writes more than system::kMostWritten for a piece is ended. So is, when there are 250,000 more
    /// files than before (and 256 for each piece), the one that has most likely made them.
    const system::Sandbox* sandbox = nullptr;
};

/// Reports to the parent that a step is done, such as a frame; the time limit starts again. The text is
/// passed to `progress`.
using Step = std::function<void(const std::string& text)>;
/// Does piece `index`. It runs in a worker, which keeps its state between pieces. A DeviceLost that it throws
/// ends the worker.
using Work = std::function<std::string(std::size_t index, const Step& step)>;

/// True in a process that runInWorkers started, which ends without harm to others.
bool isWorker();

/// The limit of time of the step that this worker is at.
struct StepTime {
    double limit = 0;  ///< seconds that the step may take
    double left = 0;   ///< seconds until this process is ended
};
/// Nothing if this is no worker, or if the step has no limit.
std::optional<StepTime> stepTime();

/// Does pieces 0 to count - 1, each once (but see `repeats`), in processes of their own; a worker that ends
/// is replaced. `done` and `progress` run in the calling process, in the order of events. Call it before any
/// thread or GL context exists. Workers ignore the signals that a terminal sends to the whole group (Ctrl-C);
/// the caller ends them by `stop`. After a stop `done` is called for the running pieces only.
///
/// Where the system copies no processes (Windows), a worker is this program started again: it must come to
/// this call, and to the same pieces, by its arguments and by what earlier calls have told their callers
/// (WorkerCalls). On its way the functions of the room system that change files do nothing.
void runInWorkers(std::size_t count, const WorkerOptions& options, const Work& work,
                  const std::function<void(std::size_t index, const Outcome&)>& done,
                  const std::function<void(std::size_t index, const std::string& text)>& progress,
                  const std::source_location& place = std::source_location::current());

}  // namespace glibra::base
