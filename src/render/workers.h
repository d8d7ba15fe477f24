#pragma once
// Work done in processes of its own: what crashes the driver, hangs or runs out of memory costs only itself.

#include <cstddef>
#include <functional>
#include <string>

namespace glibra::render {

/// How one piece of work ended.
struct Outcome {
    enum class End { finished, timedOut, crashed, stopped };
    End end = End::finished;
    std::string answer{};  ///< what the work returned, if it finished
    int signal = 0;        ///< that ended it, if it crashed; 0: it exited by itself
    int process = 0;       ///< number of the process, if it did not finish
};

struct WorkerOptions {
    int workers = 1;         ///< processes at once, at least 1
    double timeout = 0;      ///< seconds that one step of the work may take; 0: no limit
    std::size_t memory = 0;  ///< bytes of address space a worker may reserve; 0: no limit
    /// The time limit of a piece, where it is not the same for all.
    std::function<double(std::size_t index)> timeoutOf{};
    /// Asked five times a second: once true, no more pieces are begun and those in work are ended.
    std::function<bool()> stop{};
};

/// Tells the parent that a step is done (a frame, say): its time limit begins anew. The text reaches
/// `progress`.
using Step = std::function<void(const std::string& text)>;
/// Does piece `index`; runs in a worker, which keeps its state from piece to piece.
using Work = std::function<std::string(std::size_t index, const Step& step)>;

/// Does pieces 0..count-1, each exactly once, in forked workers; a worker that ends is replaced. `done` and
/// `progress` run in the calling process, in the order in which things happen. Call it before any thread or
/// GL context exists. Workers pass over the signals that a terminal sends to all (Ctrl-C): ending them is the
/// caller's decision, by `stop`. After a stop `done` is called for the pieces in work only.
void runInWorkers(std::size_t count, const WorkerOptions& options, const Work& work,
                  const std::function<void(std::size_t index, const Outcome&)>& done,
                  const std::function<void(std::size_t index, const std::string& text)>& progress);

}  // namespace glibra::render
