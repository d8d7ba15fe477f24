#pragma once
// What a subject of `glibra bench` is. The table of all subjects is in bench/subjects/subjects.h.

#include <glibra/result.h>

#include <string_view>
#include <vector>

#include "bench/core/bench.h"
#include "bench/core/measurement.h"

namespace glibra::bench {

struct Subject {
    std::string_view name;   ///< word of the command line: "primitives"
    std::string_view title;  ///< "Primitives: slices and stacks against the analytic surface"
    /// Figures in the order of the page. Errors: the driver, or a file of the library that is missing.
    Result<std::vector<Figure>> (*measure)(Bench& bench);
};

}  // namespace glibra::bench
