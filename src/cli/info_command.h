#pragma once

#include "cli/sister_program.h"

namespace glibra::cli {

/// Runs `glibra bench` and `glibra info --precision`.
inline constexpr SisterProgram kBenchProgram{
    "glibra-bench",
    "build it with `cmake --build BUILD_FOLDER --target glibra_bench_program` (this needs Boost)"};

}  // namespace glibra::cli
