#pragma once
// Claims of books about the speed of shaders, measured: one figure per claim, with a verdict.

#include <glibra/result.h>

#include <vector>

#include "bench/core/bench.h"

namespace glibra::bench {

/// Figures: one per claim, named by the row of docs/coverage.md that it answers. The first finding is the
/// verdict: "true here, by 1.8 (1.7 .. 1.9)", "false here: ...", or "no difference here".
Result<std::vector<Figure>> measureClaims(Bench& bench);

}  // namespace glibra::bench
