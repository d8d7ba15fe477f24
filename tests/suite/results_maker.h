#pragma once
// Makes random results with every member set, the same in each run.

#include <random>

#include "suite/results/results.h"

namespace glibra::suite {

class ResultsMaker {
  public:
    explicit ResultsMaker(unsigned seed) : random_(seed) {}

    ShotResult shot();
    RunResult run();  ///< without shots
    std::string text();
    double figure();

  private:
    std::size_t below(std::size_t limit) { return random_() % limit; }
    bool chance() { return below(2) == 1; }
    std::optional<double> maybe() { return chance() ? std::optional(figure()) : std::nullopt; }
    Diagnostic diagnostic();

    std::mt19937_64 random_;
};

/// Expects equality member by member. NaN equals NaN, and 0 differs from -0.
void expectEqual(const ShotResult& a, const ShotResult& b);

}  // namespace glibra::suite
