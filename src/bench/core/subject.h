#pragma once
// What a subject of `glibra bench` is. The table of all subjects is in bench/subjects/subjects.h.

#include <glibra/result.h>

#include <string_view>
#include <vector>

#include "bench/core/bench.h"
#include "bench/core/measurement.h"

namespace glibra::bench {

struct Subject {
    std::string_view name;   ///< name on the command line: "primitives"
    std::string_view title;  ///< "Primitives: slices and stacks against the analytic surface"
    /// The figures in the order of the report. Errors: no driver, or a missing file of the library.
    Result<std::vector<Figure>> (*measure)(Bench& bench);
};

}  // namespace glibra::bench
