#pragma once
// What a subject needs for measuring: the clock, the driver, and how thorough to be.

#include <glibra/result.h>

#include <exception>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bench/core/figure.h"
#include "gpu/context/context.h"
#include "system/process.h"

namespace glibra::bench {

/// Thrown where a subject cannot go on: no driver, or something that the driver refuses.
struct Failed : std::exception {
    Diagnostics diagnostics;
    explicit Failed(Diagnostics why) : diagnostics(std::move(why)) {}
    [[nodiscard]] const char* what() const noexcept override {
        return diagnostics.empty() ? "no reason is known" : diagnostics.front().text.c_str();
    }
};

/// The value. Throws Failed with the errors if there is none.
template <class Value>
Value need(Result<Value> result) {
    if (!result) throw Failed(std::move(result.diagnostics));
    return std::move(*result);
}

/// Throws Failed if there are problems.
inline void check(Diagnostics problems) {
    if (!problems.empty()) throw Failed(std::move(problems));
}

/// Runs work in a process in which no graphics driver has been loaded yet. Drivers read their settings from
/// the environment once, so comparing two settings takes two processes.
class Apart {
  public:
    /// Forks a process that waits for requests. If this process has more than one thread or has already
    /// loaded a driver, or the system has no copies of processes, nothing is forked and run() never gives an
    /// answer: in the fork, a driver's locks would stay locked forever.
    Apart();
    Apart(const Apart&) = delete;
    Apart& operator=(const Apart&) = delete;
    ~Apart();

    using Work = std::string (*)(const std::string& request);
    /// The answer of `work` to the request; each request gets a new process. Empty if that process crashed or
    /// could not be started.
    std::optional<std::string> run(Work work, const std::string& request);
    /// Why the last run() gave no answer: "ended by signal 11 (Segmentation fault)", "ended with status 1";
    /// empty if it gave one or if there is no process.
    [[nodiscard]] const std::string& failure() const { return failure_; }
    /// False if run() never gives an answer.
    [[nodiscard]] bool isThere() const { return static_cast<bool>(process_); }

  private:
    system::File requests_, answers_;  ///< ends of two pipes
    system::Process process_;
    std::string failure_;
};

/// Median and quartiles of the measurements, by linear interpolation between the closest ranks. There is at
/// least one measurement.
Timing timingOf(std::vector<double> seconds);

/// Times work by `measure`, which does it so many times and gives the seconds that took: once to warm up,
/// then until the median is stable (at least 5 measurements, for at most about `enough` seconds; 3 if
/// `quick`). Work shorter than 20 microseconds is repeated within one measurement, as often as makes the
/// measurement that long. Work of a quarter of a second or more is done 3 times in all.
Timing timingBy(const std::function<double(int times)>& measure, bool quick, double enough);

/// How many times as long one piece of work takes as another, on a machine that does other work too.
struct PairedTiming {
    Timing first, second;  ///< seconds
    Timing ratio;          ///< first / second, of each pair: not seconds
};

/// Runs the two in turn, once to warm up and then `pairs` times, each long enough to be measured.
/// `byProcessor` counts the processor time of all threads of this process, which other processes disturb less
/// than the clock; it is right only for drivers that draw on the processor. The work must wait for the
/// device.
PairedTiming timePairs(const std::function<void()>& first, const std::function<void()>& second, int pairs,
                       bool byProcessor);

/// "true here, by 1.82 (1.75 .. 1.90)": what the ratio of the times says of a claim that it is above 1. It
/// may hold without a difference, too.
std::string verdict(const Timing& ratio, bool mayBeEqual);

struct BenchOptions {
    bool quick = false;  ///< fewer settings and repeats: seconds instead of minutes in all
    Driver driver = Driver::automatic;
    /// Byte textures are filtered with eight bits, as llvmpipe does by default, and not with floats. Only the
    /// first context of a process decides, and other drivers filter as they always do.
    bool filtersInBytes = false;
};

class Bench {
  public:
    using Measure = std::vector<Figure> (*)(Bench& bench);
    explicit Bench(const BenchOptions& options);
    Bench(const Bench&) = delete;
    Bench& operator=(const Bench&) = delete;
    ~Bench();

    [[nodiscard]] const BenchOptions& options() const;
    [[nodiscard]] bool isQuick() const { return options().quick; }
    /// The first of the two in a quick run.
    template <class Value>
    [[nodiscard]] Value pick(Value quick, Value thorough) const {
        return isQuick() ? std::move(quick) : std::move(thorough);
    }
    /// The only context of the run, opened at the first call. Throws Failed with gpu-E01.
    gpu::Context& context();
    const gpu::Capabilities& capabilities() { return context().capabilities(); }

    /// Times `work` (`timingBy`). Work on the device must wait for the device (glFinish) before it returns.
    [[nodiscard]] Timing time(const std::function<void()>& work, double enough = .5) const;
    /// Times drawing and waiting for it.
    [[nodiscard]] Timing timeDrawing(const std::function<void()>& draw) const;

    /// Does what needs the driver; if that fails, the rest of the subject is measured all the same, and
    /// problems() say why.
    void attempt(const std::function<void()>& work);
    /// Adds to problems(), each message once.
    void report(const Diagnostics& diagnostics);
    /// What could not be measured, and why.
    [[nodiscard]] const Diagnostics& problems() const;

    /// A process without a driver, forked by the constructor.
    Apart& apart();

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace glibra::bench
