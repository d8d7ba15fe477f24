#pragma once
// What a subject measures with: the clock, the driver, and how thorough to be.

#include <glibra/result.h>

#include <functional>
#include <memory>
#include <string_view>
#include <vector>

#include "bench/core/apart.h"
#include "bench/core/measurement.h"
#include "gpu/context.h"

namespace glibra::bench {

struct BenchOptions {
    bool quick = false;  ///< fewer settings and repeats, seconds instead of minutes in all
    Driver driver = Driver::automatic;
};

/// Median and quartiles of measurements, not empty, by linear interpolation between the closest ranks.
Timing timingOf(std::vector<double> seconds);

class Bench {
  public:
    explicit Bench(const BenchOptions& options);
    Bench(const Bench&) = delete;
    Bench& operator=(const Bench&) = delete;
    ~Bench();

    [[nodiscard]] bool isQuick() const;
    /// The one context of the run, opened when first asked for. gpu-E01.
    Result<gpu::Context*> context();
    /// A process without a driver, forked when the bench was made.
    Apart& apart();
    /// Times `work`: once to warm up, then until the median stands (at least 5 times, at most about `enough`
    /// seconds; in a quick run 3 times). Work shorter than 20 microseconds is repeated inside one
    /// measurement; work of a quarter of a second and more is done 3 times in all. Work on the device must
    /// wait for it (glFinish) before it returns.
    [[nodiscard]] Timing time(const std::function<void()>& work, double enough = .5) const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace glibra::bench
