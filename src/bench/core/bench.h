#pragma once
// What a subject needs for measuring: the clock, the driver, and how thorough to be.

#include <glibra/result.h>

#include <functional>
#include <memory>
#include <string_view>
#include <vector>

#include "bench/core/apart.h"
#include "bench/core/measurement.h"
#include "gpu/context/context.h"

namespace glibra::bench {

struct BenchOptions {
    bool quick = false;  ///< fewer settings and repeats: seconds instead of minutes in all
    Driver driver = Driver::automatic;
};

/// Median and quartiles of the measurements, by linear interpolation between the closest ranks. There is at
/// least one measurement.
Timing timingOf(std::vector<double> seconds);

/// Times work by `measure`, which does it so many times and gives the seconds that took: once to warm up,
/// then until the median is stable (at least 5 measurements, for at most about `enough` seconds; 3 if
/// `quick`). Work shorter than 20 microseconds is repeated within one measurement, as often as makes the
/// measurement that long. Work of a quarter of a second or more is done 3 times in all.
Timing timingBy(const std::function<double(int times)>& measure, bool quick, double enough);

class Bench {
  public:
    explicit Bench(const BenchOptions& options);
    Bench(const Bench&) = delete;
    Bench& operator=(const Bench&) = delete;
    ~Bench();

    [[nodiscard]] bool isQuick() const;
    /// The only context of the run, opened at the first call. gpu-E01.
    Result<gpu::Context*> context();
    /// A process without a driver, forked by the constructor.
    Apart& apart();
    /// Times `work` (`timingBy`). Work on the device must wait for the device (glFinish) before it returns.
    [[nodiscard]] Timing time(const std::function<void()>& work, double enough = .5) const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace glibra::bench
